// Starts a real headless Chromium with a fresh profile and opens reports in it.
import {createRequire} from "node:module";
import {existsSync, mkdtempSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import path from "node:path";
import {pathToFileURL} from "node:url";

/** How much was looked at, and what did not hold. */
export const checked = {count: 0, failures: []};

/** Counts a check; says what does not hold. */
export function check(holds, words) {
  ++checked.count;
  if (!holds) {
    checked.failures.push(words);
    console.error("FAILED: " + words);
  }
}

/** Path of Chromium: $PHS_CHROMIUM or where the distributions put it; exits without one. */
export function findChromium() {
  const found = [process.env.PHS_CHROMIUM, "/usr/bin/chromium", "/usr/bin/chromium-browser",
    "/usr/bin/google-chrome"].find((file) => file && existsSync(file));
  if (!found) {
    console.error("no Chromium found: install the package chromium or set PHS_CHROMIUM");
    process.exit(2);
  }
  return found;
}

/** Runs `work(browser)`; the browser and its profile are gone afterwards. `drawing`: how it draws. */
export async function withBrowser(modules, work, drawing = ["--disable-3d-apis"]) {
  const require = createRequire(path.join(path.resolve(modules), "from.cjs"));
  const profile = mkdtempSync(path.join(tmpdir(), "phs-browser-"));
  const browser = await require("puppeteer-core").launch({
    executablePath: findChromium(),
    userDataDir: profile,
    args: ["--headless", "--no-sandbox", "--disable-gpu", ...drawing, "--disable-quic", "--no-first-run",
      "--disable-background-networking", "--disable-component-update", "--disable-sync"],
  });
  try {
    await work(browser);
  } finally {
    await browser.close();
    rmSync(profile, {recursive: true, force: true});
  }
}

/** Opens a report and waits until every figure is drawn. `watch` gathers messages and requests. */
export async function openReport(browser, file, width, scheme, watch = {messages: [], requests: []}) {
  const page = await browser.newPage();
  page.on("console", (message) => watch.messages.push(message.text()));
  page.on("pageerror", (error) => watch.messages.push(String(error)));
  page.on("request", (request) => {
    const url = request.url();
    if (!url.startsWith("file:") && !url.startsWith("data:")) watch.requests.push(url);
  });
  await page.setViewport({width, height: width < 500 ? 844 : 900,
    deviceScaleFactor: width < 500 ? 2 : 1});
  await page.emulateMediaFeatures([{name: "prefers-color-scheme", value: scheme}]);
  await page.goto(pathToFileURL(path.resolve(file)).href);
  await page.waitForFunction(() => document.documentElement.dataset.ready === "yes",
    {timeout: 30000});
  return page;
}
