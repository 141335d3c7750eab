// The built site in headless Chromium, from the disk and without a network: every page asks for nothing outside
// itself, says nothing on the console and is not wider than a telephone; equations are typeset; search finds.
// browser_test.mjs NODE_MODULES_DIR SITE PICTURES
import assert from "node:assert/strict";
import {mkdirSync, readdirSync} from "node:fs";
import path from "node:path";
import {pathToFileURL} from "node:url";
import {withBrowser} from "../report/browser.mjs";

const [modules, site, pictures] = process.argv.slice(2);
const pages = readdirSync(site, {recursive: true})
  .filter((file) => file.endsWith(".html") && file !== "404.html").sort();  // that one is for a server's root
const shown = ["index.html", "physics_rail.html", "reference/files.html", "reference/python.html",
  "tutorials/first_curve.html", "oil_temperature.html"];

async function open(browser, watch, width) {
  const page = await browser.newPage();
  page.on("console", (message) => {
    // The first letters of a search may be asked before the index is worked out: the next ask again.
    if (!message.text().startsWith("Invalid query")) watch.faults.push(`${watch.at}: ${message.text()}`);
  });
  page.on("pageerror", (error) => watch.faults.push(`${watch.at}: ${error}`));
  page.on("requestfailed", (request) => watch.faults.push(`${watch.at}: failed: ${request.url()}`));
  page.on("request", (request) => {
    if (!/^(file|data|about|blob):/.test(request.url())) watch.faults.push(`${watch.at}: asks for ${request.url()}`);
  });
  await page.setOfflineMode(true);
  await page.setViewport({width, height: width < 500 ? 844 : 900, deviceScaleFactor: width < 500 ? 2 : 1});
  return page;
}

async function go(page, watch, name) {
  watch.at = name;
  await page.bringToFront();  // one that is hidden draws nothing
  await page.goto(pathToFileURL(path.resolve(site, name)).href, {waitUntil: "load"});
}

// Every page reads the index of all words, 1.5 MB, and works it out, which takes longer than all that is looked at:
// it gets an empty one, but for where something is searched.
const emptyIndex = 'var __search = {index: Promise.resolve({config: {lang: ["en"], separator: " "}, docs: []})}';

/** Lets the page read every file but the index of words; gives back what ends that. */
async function withoutIndex(page) {
  const answer = (request) => request.url().endsWith("/search/search_index.js")
    ? request.respond({contentType: "text/javascript", body: emptyIndex}) : request.continue();
  await page.setRequestInterception(true);
  page.on("request", answer);
  return async () => {
    page.off("request", answer);
    await page.setRequestInterception(false);
  };
}

async function search(page, watch, from, words) {
  await go(page, watch, from);
  await page.waitForSelector("[data-md-component=search-query]");
  await page.click("[data-md-component=search-query]");
  await page.keyboard.type(words);
  await page.waitForSelector(".md-search-result__item a", {timeout: 20000});
  return page.$$eval(".md-search-result__item a", (links) => links.map((link) => link.href));
}

mkdirSync(pictures, {recursive: true});
const watch = {at: "", faults: []};
await withBrowser(modules, async (browser) => {
  const desk = await open(browser, watch, 1400);
  let equations = 0;
  const withIndex = await withoutIndex(desk);
  for (const name of pages) {
    await go(desk, watch, name);
    const found = await desk.evaluate(() => ({
      title: document.querySelector("article h1")?.textContent ?? "",
      broken: [...document.images].filter((image) => !image.complete || image.naturalWidth === 0).length,
      equations: document.querySelectorAll(".equation .katex-html").length,
      errors: document.querySelectorAll(".katex-error").length,
      wide: document.documentElement.scrollWidth - innerWidth,
    }));
    assert(found.title.length > 2, `${name}: no heading`);
    assert.equal(found.broken, 0, `${name}: pictures that do not show`);
    assert.equal(found.errors, 0, `${name}: equations with errors`);
    assert(found.wide <= 0, `${name}: ${found.wide} px too wide at 1400`);
    equations += found.equations;
    await desk.setViewport({width: 390, height: 844});
    const wide = await desk.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert(wide <= 0, `${name}: ${wide} px too wide at 390`);
    await desk.setViewport({width: 1400, height: 900});
  }
  await withIndex();
  assert(equations > 40, `${equations} equations`);

  // The fonts of KaTeX come from the site itself.
  await go(desk, watch, "physics_rail.html");
  assert(await desk.evaluate(async () => {
    await document.fonts.ready;
    return [...document.fonts].some((font) => font.family.startsWith("KaTeX") && font.status === "loaded");
  }), "no font of KaTeX was loaded");

  const hits = await search(desk, watch, "index.html", "precharge");
  assert(hits.some((link) => /phs_models\.html|oil_temperature\.html|identify\.html/.test(link)), `${hits}`);
  const deeper = await search(desk, watch, "tutorials/first_curve.html", "FASTSIM");
  assert(deeper.some((link) => link.includes("/physics_rail.html")), `${deeper}`);
  assert(deeper.every((link) => link.startsWith("file:")), `${deeper}`);
  await desk.screenshot({path: path.join(pictures, "search.png")});

  const phone = await open(browser, watch, 390);
  for (const [page, width] of [[desk, 1400], [phone, 390]]) {
    for (const name of shown) {
      await go(page, watch, name);
      await page.screenshot({path: path.join(pictures, `${name.replace(/\W/g, "_")}_${width}.png`)});
    }
  }
  await desk.evaluate(() => localStorage.clear());  // the choice of the page opened before
  await desk.emulateMediaFeatures([{name: "prefers-color-scheme", value: "dark"}]);
  await go(desk, watch, "physics_rail.html");
  await desk.screenshot({path: path.join(pictures, "dark.png")});
});
assert.deepEqual(watch.faults, []);
console.log(`${pages.length} pages`);
