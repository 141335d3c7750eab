// The replay of a report in a real headless Chromium, with WebGL in software and without any.
//
//   node replay_test.mjs NODE_MODULES_DIR PICTURES_DIR REPORT.html
//
// The report is one of a real run of two bogies. With WebGL: the scene starts after the plots, shows
// something, follows the cursor of the plots and moves it, runs by itself, magnifies, shows a ghost;
// wheels and patches follow too. Without: a sentence in its place. Never a console message or a
// request; the page stays below 5 MB. Exit 0 if all holds; screenshots stay in PICTURES_DIR.
import {existsSync, mkdirSync, readFileSync, statSync} from "node:fs";
import path from "node:path";
import {check, checked, openReport, withBrowser} from "./browser.mjs";

const [modules, pictures, report] = process.argv.slice(2);
if (!report) {
  console.error("usage: replay_test.mjs NODE_MODULES_DIR PICTURES_DIR REPORT.html");
  process.exit(2);
}
// Plots stay with the processor: drawn by a graphics card in software they take minutes.
const kSoftware = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
  "--disable-accelerated-2d-canvas", "--disable-gpu-rasterization"];
const kMost = 5e6;

const place = (page) => page.$eval("figure.replay", (f) => Number(f.dataset.place));
const profilePlace = (page) => page.$eval("figure.profiles", (f) => Number(f.dataset.place));
const body = (page) => page.$eval("figure.replay", (f) => f.scene.look(0).body.join());
/** A number of the picture that changes with any of its pixels. */
const picture = (page) => page.$eval("figure.replay canvas", (canvas) => {
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
  copy.drawImage(canvas, 0, 0);
  const {data} = copy.getImageData(0, 0, canvas.width, canvas.height);
  let sum = 0;
  const colours = new Set();
  for (let i = 0; i < data.length; i += 4) {
    const rgb = data[i] << 16 | data[i + 1] << 8 | data[i + 2];
    sum = (sum * 31 + rgb) % 1000000007;
    if (colours.size < 500) colours.add(rgb);
  }
  return {sum, colours: colours.size};
});
async function drawn(page, work) {
  const frames = () => page.$eval("figure.replay", (f) => Number(f.dataset.frames));
  const before = await frames();
  await work();
  await page.waitForFunction((n) => Number(document.querySelector("figure.replay").dataset.frames) > n,
    {timeout: 60000}, before);
  await new Promise((resolve) => setTimeout(resolve, 400));
}
const slide = (page, share) => page.$eval("figure.replay .bar input", (slider, part) => {
  slider.value = Number(slider.min) + part * (slider.max - slider.min);
  slider.dispatchEvent(new Event("input"));
}, share);
const choose = (page, label, value) => page.evaluate((words, chosen) => {
  const field = [...document.querySelectorAll("figure.replay label")]
    .find((l) => l.textContent.startsWith(words) || l.textContent.trim() === words);
  const input = field.querySelector("select, input");
  if (input.tagName === "SELECT") input.value = chosen;
  else input.checked = chosen;
  input.dispatchEvent(new Event("change"));
}, label, value);

async function open(browser, width, scheme, watch) {
  const page = await openReport(browser, report, width, scheme, watch);
  check(await page.$("figure.replay") !== null, "there is a replay");
  await page.$eval("figure.replay", (f) => f.scrollIntoView({behavior: "instant"}));
  await page.waitForFunction(() => document.querySelector("figure.replay").dataset.scene, {timeout: 60000});
  // By the page's own marks: a quick machine has both before it is asked.
  const [first, scene] = await page.evaluate(() => ["phs-first", "phs-scene"]
    .map((name) => performance.getEntriesByName(name)[0].startTime));
  check(first < scene, `plots and tables come before the scene: ${first} and ${scene} ms`);
  return page;
}

async function follow(page) {
  const whole = await picture(page);
  check(whole.colours > 100, `the scene shows something: ${whole.colours} colours`);
  // From a plot to the replay.
  const over = await page.evaluateHandle(() => [...document.querySelectorAll("figure.series")]
    .find((f) => f.plot && f.dataset.group === "distance" && !f.closest("details:not([open])"))
    .querySelector(".u-over"));
  const before = {place: await place(page), body: await body(page)};
  await over.evaluate((o) => o.scrollIntoView({behavior: "instant", block: "center"}));
  const box = await over.boundingBox();
  await page.mouse.move(box.x + 0.4 * box.width, box.y + 0.5 * box.height);
  await drawn(page, () => page.mouse.move(box.x + 0.25 * box.width, box.y + 0.5 * box.height));
  const wanted = await over.evaluate((o) => {
    const {plot} = o.closest("figure");
    return plot.posToVal(0.25 * o.clientWidth, "x");
  });
  const after = {place: await place(page), body: await body(page)};
  check(Math.abs(after.place - wanted) < 1, `the plots' cursor moves the replay: ${after.place}, ${wanted}`);
  check(after.place !== before.place && after.body !== before.body, "and the bogie in it");
  check(Math.abs(await profilePlace(page) - wanted) < 1, "and the wheels on their rails");
  check((await picture(page)).sum !== whole.sum, "and the picture");
  // From the replay to the plots and the plan.
  await page.mouse.move(2, 2);
  const plan = await page.$eval(".plan input[type=range]", (s) => s.value);
  await over.evaluate((o) => o.scrollIntoView({behavior: "instant", block: "center"}));
  await drawn(page, () => slide(page, 0.8));
  const read = () => over.evaluate((o) => {
    const {plot} = o.closest("figure");
    return plot.posToVal(plot.cursor.left, "x");
  });
  // Plots follow ten times a second at most, on a busy machine later.
  let cursor = await read();
  for (let tries = 0; tries < 100 && Math.abs(cursor - await place(page)) >= 1; ++tries) {
    await new Promise((resolve) => setTimeout(resolve, 100));
    cursor = await read();
  }
  check(Math.abs(cursor - await place(page)) < 1, `the replay moves the plots' cursor: ${cursor}`);
  check(await page.$eval(".plan input[type=range]", (s) => s.value) !== plan, "and the plan view");
  const patches = await page.$$eval("figure.profiles ellipse", (all) => all.length);
  check(patches >= 4, `every leading wheel has a patch: ${patches}`);
}

async function run(page) {
  await page.$eval("figure.replay", (f) => f.scrollIntoView({behavior: "instant"}));
  await drawn(page, () => slide(page, 0.5));
  const at = await place(page);
  // Clicked by the page itself: a busy machine may take so long to aim that the run is over.
  const click = () => page.$eval("figure.replay .play", (button) => button.click());
  await drawn(page, click);
  for (let tries = 0; tries < 100 && await place(page) <= at + 0.5; ++tries) {
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  await click();
  const then = await place(page);
  check(then > at + 0.5, `it runs: ${at} to ${then} m`);
  await new Promise((resolve) => setTimeout(resolve, 500));
  check(await place(page) === then, "and stops");
  const plain = await picture(page);
  await drawn(page, () => choose(page, "Drawn", "1"));
  const magnified = await picture(page);
  check(magnified.sum !== plain.sum, "magnified it looks otherwise");
  await drawn(page, () => choose(page, "forces", false));
  check((await picture(page)).sum !== magnified.sum, "arrows can be left away");
  const captions = () => page.$$eval("figure.replay .captions > div", (all) => all.length);
  check(await captions() === 2, "two bogies side by side");
  await drawn(page, () => choose(page, "one as a ghost in the other", true));
  check(await captions() === 1, "one in the other as a ghost");
  const who = await page.$eval("figure.replay .who", (p) => p.textContent);
  check(/PHS: solid.*rigid link: the ghost, reddish/.test(who), `the colours are told: ${who}`);
  await drawn(page, () => page.focus("figure.replay canvas").then(() => page.keyboard.press("ArrowLeft")));
}

/** The conicity that is drawn is the one of the results; its table and file hold it too. */
async function conicity(page) {
  const file = path.join(path.dirname(report), "compare.json");
  check(existsSync(file), "there are results beside the page");
  const saved = JSON.parse(readFileSync(file)).bogies.phs.conicity.curves;
  check(saved.length === 2 && saved[0].amplitude_m.length > 4, "with a conicity, rigid and elastic");
  const {curves, rows, text} = await page.evaluate(() => {
    const figure = [...document.querySelectorAll("figure.xy")]
      .find((f) => f.textContent.includes("Equivalent conicity"));
    figure.scrollIntoView({behavior: "instant"});
    const spec = JSON.parse(document.getElementById("figures").textContent)[figure.id];
    const button = figure.querySelector(".data-button");
    button.click();
    const table = [...figure.querySelectorAll(".data-rows tr")].map((row) => [...row.cells].map((c) => c.textContent));
    button.click();
    return {curves: spec.curves.map(({label, x, y}) => ({label, x: phs.unpack(x), y: phs.unpack(y)})),
      rows: table, text: figure.closest("section").textContent};
  });
  const drawn = curves.filter(({label}) => /rigid bodies|elastic/.test(label));
  check(drawn.length >= saved.length, `curves: ${curves.map((c) => c.label).join("; ")}`);
  saved.forEach((own, i) => {
    const {x, y} = drawn[i];
    const span = Math.max(...own.equivalent) - Math.min(...own.equivalent);
    const away = own.equivalent.map((value, k) => Math.abs(value - y[k]) / span);
    check(x.length === own.amplitude_m.length && Math.max(...away) < 2e-5,
      `curve ${i} is the one computed: off by ${Math.max(...away)} of its range`);
    check(own.amplitude_m.every((value, k) => Math.abs(1e3 * value - x[k]) < 1e-3), "over its amplitudes");
  });
  check(rows.length > saved[0].amplitude_m.length, `the numbers are there as a table: ${rows.length} rows`);
  for (const words of ["S1002.prw", "UIC60.prr", "gauge", "EN 15302", "3 mm"]) {
    check(text.includes(words), `the section says ${words}`);
  }
}

mkdirSync(pictures, {recursive: true});
const bytes = statSync(report).size;
check(bytes < kMost, `the page has ${bytes} bytes`);
const times = [];
await withBrowser(modules, async (browser) => {
  for (const [width, scheme] of [[1400, "light"], [390, "dark"]]) {
    const watch = {messages: [], requests: []};
    const page = await open(browser, width, scheme, watch);
    times.push(await page.evaluate(() => Math.round(performance.getEntriesByName("phs-first")[0]?.startTime)));
    if (width > 1000) {
      await follow(page);
      await run(page);
      await conicity(page);
    } else {
      check((await picture(page)).colours > 100, "the scene shows something on a phone");
    }
    const wide = await page.evaluate(() => document.scrollingElement.scrollWidth - innerWidth);
    check(wide <= 1, `${width} px: the page scrolls sideways by ${wide}`);
    const clip = await page.evaluate(() => {
      const top = document.querySelector("figure.replay").getBoundingClientRect().top + scrollY;
      return {top, bottom: document.querySelector("figure.profiles").getBoundingClientRect().bottom + scrollY};
    });
    await page.screenshot({path: path.join(pictures, `replay-${width}-${scheme}.png`), captureBeyondViewport: true,
      clip: {x: 0, y: clip.top, width, height: clip.bottom - clip.top}});
    // The driver's own word on this test's reading of pixels.
    watch.messages = watch.messages.filter((text) => !text.includes("GPU stall due to ReadPixels"));
    check(watch.messages.length === 0, `${width} px: console: ${watch.messages.join(" | ")}`);
    check(watch.requests.length === 0, `${width} px: asks the network: ${watch.requests.join(" | ")}`);
    await page.close();
  }
}, kSoftware);
await withBrowser(modules, async (browser) => {
  const watch = {messages: [], requests: []};
  const page = await open(browser, 1400, "light", watch);
  check(await page.$eval("figure.replay", (f) => f.dataset.scene) === "none", "no scene without WebGL");
  check((await page.$eval("figure.replay", (f) => f.textContent)).includes("WebGL"), "but a sentence");
  check(await page.$$eval("figure.profiles ellipse", (all) => all.length) >= 4, "and the wheels");
  check(watch.messages.length === 0, `without WebGL: console: ${watch.messages.join(" | ")}`);
  check(watch.requests.length === 0, `without WebGL: asks the network: ${watch.requests.join(" | ")}`);
}, ["--disable-3d-apis"]);
console.log(`${(bytes / 1e6).toFixed(2)} MB; first table and plots after ${times.join(" and ")} ms`);
console.log(`${checked.count - checked.failures.length} passed, ${checked.failures.length} failed`);
process.exit(checked.failures.length === 0 && checked.count > 0 ? 0 : 1);
