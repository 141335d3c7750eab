// Opens reports in a real headless Chromium and looks at them as a reader would.
//
//   node browser_test.mjs NODE_MODULES_DIR PICTURES_DIR REPORT.html…
//
// The first report is looked at at 1400 px and 390 px width, light and dark, the others at 1400 px
// light and 390 px dark: no console message, nothing asked
// from the network, every figure drawn (pixels or shapes that differ from the ground), no text
// beyond the page; zoom, legend and slider work; moving shapes stand at their phase, run when told to
// and only then. Exit 0 if all holds; screenshots stay in
// PICTURES_DIR.
import {mkdirSync} from "node:fs";
import path from "node:path";
import {check, checked, openReport, withBrowser} from "./browser.mjs";

const [modules, pictures, ...reports] = process.argv.slice(2);
if (!modules || !pictures || reports.length === 0) {
  console.error("usage: browser_test.mjs NODE_MODULES_DIR PICTURES_DIR REPORT.html…");
  process.exit(2);
}


/** Figures that are empty: no figure body, or a canvas on which no curve has been drawn. */
const findEmptyFigures = () => [...document.querySelectorAll("figure.plot")].filter((figure) => {
  if (figure.closest("details:not([open])")) return false;
  if (["plan", "heat", "shape"].includes(figure.dataset.kind)) {
    return figure.querySelectorAll("svg path, svg rect").length < 4;
  }
  const canvas = figure.querySelector("canvas");
  if (!canvas || canvas.width < 100) return true;
  const copy = new OffscreenCanvas(canvas.width, canvas.height)
    .getContext("2d", {willReadFrequently: true});
  copy.drawImage(canvas, 0, 0);
  const {data} = copy.getImageData(0, 0, canvas.width, canvas.height);
  let coloured = 0;  // pixels whose channels differ clearly: only curves are coloured
  for (let i = 0; i < data.length; i += 4) {
    const spread = Math.max(data[i], data[i + 1], data[i + 2]) -
      Math.min(data[i], data[i + 1], data[i + 2]);
    if (data[i + 3] > 100 && spread > 40) ++coloured;
  }
  return coloured < 40;
}).map((figure) => figure.querySelector("figcaption").textContent);

/** Elements that stick out of the page to the right, outside of boxes that scroll. */
const findOverflow = () => {
  const limit = document.documentElement.clientWidth;
  const found = [...document.querySelectorAll("body *")].filter((element) => {
    const box = element.getBoundingClientRect();
    if (box.width === 0 || box.right <= limit + 1) return false;
    return !element.closest(".scroll, pre, .u-over, .u-under, svg");
  }).map((element) => element.tagName + "." + element.className + ": " +
    element.textContent.trim().slice(0, 40));
  if (document.scrollingElement.scrollWidth > limit + 1) found.push("the page scrolls sideways");
  return found;
};

/** Texts of drawings that lie over the edge of their drawing. */
const findCutTexts = () => [...document.querySelectorAll(".drawing svg")].flatMap((svg) => {
  const frame = svg.getBoundingClientRect();
  return [...svg.querySelectorAll("text")].filter((text) => {
    const box = text.getBoundingClientRect();
    return box.width > 0 && (box.left < frame.left - 1 || box.right > frame.right + 1 ||
      box.top < frame.top - 2 || box.bottom > frame.bottom + 2);
  }).map((text) => text.textContent);
});

/** Text and ground colours whose contrast is below 4.5. */
const findWeakContrast = () => {
  const light = (text) => {
    const parts = text.match(/[\d.]+/g).map(Number);
    const [r, g, b] = parts.slice(0, 3).map((v) => {
      const c = v / 255;
      return c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
    });
    return {level: 0.2126 * r + 0.7152 * g + 0.0722 * b, alpha: parts[3] ?? 1};
  };
  const groundOf = (element) => {
    for (let e = element; e; e = e.parentElement) {
      const ground = light(getComputedStyle(e).backgroundColor);
      if (ground.alpha === 1) return ground.level;
    }
    return 1;
  };
  return [...document.querySelectorAll("p, td, th, dt, dd, li, button, figcaption, summary")]
    .filter((element) => {
      if (!element.textContent.trim() || element.closest("[aria-pressed=false], .u-off")) return false;
      const a = light(getComputedStyle(element).color).level;
      const b = groundOf(element);
      return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05) < 4.5;
    }).map((element) => element.tagName + ": " + element.textContent.trim().slice(0, 40));
};

const abscissae = (page, group) => page.evaluate((name) =>
  [...document.querySelectorAll("figure.series")].filter((f) => f.plot && f.dataset.group === name)
    .map((f) => [f.plot.scales.x.min, f.plot.scales.x.max]), group);

async function tryControls(page, name) {
  let first = null;
  for (const figure of await page.$$("figure.series")) {
    const folded = await figure.evaluate((f) => f.closest("details:not([open])") !== null);
    if (!first && !folded) first = figure;
  }
  if (!first) return;
  const group = await first.evaluate((figure) => figure.dataset.group);
  const over = await first.$(".u-over");
  await over.scrollIntoView();
  const box = await over.boundingBox();
  const before = await abscissae(page, group);
  await page.mouse.move(box.x + 0.3 * box.width, box.y + 0.5 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.6 * box.width, box.y + 0.5 * box.height, {steps: 5});
  await page.mouse.up();
  const zoomed = await abscissae(page, group);
  const wanted = [0.3, 0.6].map((part) => before[0][0] + part * (before[0][1] - before[0][0]));
  const span = before[0][1] - before[0][0];
  check(zoomed.every((x) => Math.abs(x[0] - wanted[0]) < 0.02 * span &&
    Math.abs(x[1] - wanted[1]) < 0.02 * span), `${name}: dragging zooms every plot of the group`);
  await page.mouse.click(box.x + 0.5 * box.width, box.y + 0.5 * box.height, {clickCount: 2});
  const back = await abscissae(page, group);
  check(back.every((x) => Math.abs(x[0] - before[0][0]) < 2e-3 * span &&
    Math.abs(x[1] - before[0][1]) < 2e-3 * span), `${name}: double click shows the whole run`);
  const legend = await first.$(".u-legend .u-series:nth-child(2) th");
  await legend.click();
  const hidden = await page.evaluate((f) => {
    const label = f.plot.series[1].label;
    return [...document.querySelectorAll("figure.series")]
      .filter((other) => other.plot && other.dataset.group === f.dataset.group)
      .flatMap((other) => other.plot.series.filter((s) => s.label === label).map((s) => s.show));
  }, first);
  check(hidden.length > 0 && hidden.every((shown) => !shown),
    `${name}: a click on a name hides the curve everywhere`);
  await legend.click();
  const button = await page.$(".zoom button[data-begin]");
  if (button) {
    await button.click();
    const wantedRange = await button.evaluate((b) => [Number(b.dataset.begin), Number(b.dataset.end)]);
    const shown = await abscissae(page, await button.evaluate((b) =>
      b.closest(".zoom").dataset.group));
    check(shown.length > 0 && shown.every((x) => Math.abs(x[0] - wantedRange[0]) < 1 && Math.abs(x[1] - wantedRange[1]) < 1),
      `${name}: zoom button shows its part`);
    await (await page.$(".zoom button:not([data-begin])")).click();
  }
  const slider = await page.$(".plan input[type=range]");
  if (slider) {
    const words = () => page.$eval(".plan .views", (views) => views.innerHTML);
    const old = await words();
    await slider.focus();
    await page.keyboard.press("Home");
    check(await words() !== old, `${name}: the slider moves the bogies`);
  }
}

/** Shapes that move: still at first, at the phase of the slider, running from button to button, and
 * in single steps where less motion is asked for. */
async function tryShapes(page, name) {
  const figure = await page.$("figure.shape");
  if (!figure) return;
  const wait = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
  const paths = () => page.$$eval("figure.shape svg path.moves",
    (all) => all.map((path) => path.getAttribute("d")).join());
  const phase = () => figure.evaluate((f) => Number(f.dataset.phase));
  const turnTo = (degrees) => figure.$eval("input", (input, value) => {
    input.value = value;
    input.dispatchEvent(new Event("input"));
  }, degrees);
  const rest = await paths();
  await wait(250);
  check(await phase() === 0 && await paths() === rest, `${name}: a shape stands still at first`);
  await turnTo(90);
  // Where the ends of the lines stand, in metres of the scale bar about the first end.
  const off = await page.evaluate((degrees) => {
    const specs = JSON.parse(document.getElementById("figures").textContent);
    const worst = [];
    for (const figure of document.querySelectorAll("figure.shape")) {
      const {lines} = specs[figure.id];
      const scale = Number(/h([\d.]+)/.exec([...figure.querySelectorAll("svg path:not(.moves)")].pop()
        .getAttribute("d"))[1]);
      const drawn = [...figure.querySelectorAll("svg path.moves")].map((path) =>
        path.getAttribute("d").match(/[\d.]+/g).map(Number));
      const cos = Math.cos(degrees * Math.PI / 180), sin = Math.sin(degrees * Math.PI / 180);
      const wanted = lines.map(({from, to}) => [from, to].flatMap((p) =>
        [p.x + p.dx[0] * cos - p.dx[1] * sin, -(p.y + p.dy[0] * cos - p.dy[1] * sin)]));
      if (drawn.length !== lines.length || !(scale > 10)) return Infinity;
      worst.push(...drawn.map((d, i) => Math.max(...d.map((v, k) =>
        Math.abs((v - drawn[0][k % 2]) / scale - (wanted[i][k] - wanted[0][k % 2]))))));
    }
    return Math.max(...worst);
  }, 90);
  check(off < 0.01, `${name}: at 90° a shape is drawn ${off} m off`);
  check(await paths() !== rest, `${name}: the slider turns the phase`);
  const button = await figure.$("button.play");
  await turnTo(0);
  await button.click();
  await wait(500);
  const later = await phase();
  check(later > 10 && later < 180, `${name}: half a second of play turns the phase to ${later}°`);
  await button.click();
  const stopped = await phase();
  const there = await paths();
  await wait(250);
  check(await phase() === stopped && await paths() === there, `${name}: pause stops a shape`);
  const features = (await page.evaluate(() => matchMedia("(prefers-color-scheme: dark)").matches))
    ? "dark" : "light";
  await page.emulateMediaFeatures([{name: "prefers-color-scheme", value: features},
    {name: "prefers-reduced-motion", value: "reduce"}]);
  await turnTo(0);
  await button.click();
  await wait(250);
  check(await phase() === 30, `${name}: with less motion asked for, the button goes on by one step`);
  await page.emulateMediaFeatures([{name: "prefers-color-scheme", value: features}]);
  await turnTo(0);
}

/** Opens the data of plots, and takes the files that the buttons save without a disk. */
async function tryData(page, name) {
  const found = await page.evaluate(async () => {
    const saved = [];
    const make = URL.createObjectURL;
    URL.createObjectURL = (blob) => (saved.push(blob.text()), "data:,");
    const click = HTMLAnchorElement.prototype.click;
    const names = [];
    HTMLAnchorElement.prototype.click = function () { names.push(this.download); };
    const out = {plots: 0, without: [], panels: [], tables: 0, bars: 0};
    for (const figure of document.querySelectorAll("figure.plot")) {
      if (figure.closest("details:not([open])")) continue;
      const toggle = figure.querySelector("figcaption .data-button");
      if (!toggle) {
        out.without.push(figure.dataset.kind);
        continue;
      }
      ++out.plots;
      if (out.plots > 6) continue;
      toggle.click();
      figure.querySelector(".data-panel .data-button").click();
      out.panels.push(figure.querySelectorAll(".data-panel tbody tr").length);
      toggle.click();
      if (figure.querySelector(".data-panel")) out.panels.push("stays open");
    }
    const press = (selector) => {
      const buttons = document.querySelectorAll(selector);
      buttons[0]?.click();
      return buttons.length;
    };
    out.tables = press(".caption > .data-button");
    out.bars = press("figure.bars .data-button");
    URL.createObjectURL = make;
    HTMLAnchorElement.prototype.click = click;
    out.files = await Promise.all(saved);
    out.names = names;
    return out;
  });
  check(found.tables > 0, `${name}: tables can be saved`);
  check(found.panels.every((rows) => rows > 0 && rows <= 200),
    `${name}: rows of data: ${found.panels.join(" ")}`);
  check(found.names.length === found.files.length && found.names.every((n) => /^[a-z0-9_]+\.csv$/.test(n)),
    `${name}: names of files: ${found.names.join(" ")}`);
  for (const [i, text] of found.files.entries()) {
    const bare = text.replace(/"(?:[^"]|"")*"/g, "");  // quoted cells may hold commas and lines
    const rows = bare.trimEnd().split("\n");
    const width = rows[0].split(",").length;
    check(rows.length > 1 && rows.every((row) => row.split(",").length <= width),
      `${name}: ${found.names[i]} is a table`);
    check(i >= Math.min(found.plots, 6) || rows.slice(1).every((row) => /^[-+\d.e,]*$/.test(row)),
      `${name}: ${found.names[i]} holds numbers alone: ${rows[1]}`);
  }
  return found;
}

/** On paper: no buttons, nothing wider than the page, every figure still there. */
async function tryPaper(page, name) {
  await page.emulateMediaType("print");
  const shown = await page.evaluate(() => [...document.querySelectorAll(
    "button, .zoom, input, nav, .data-panel")].filter((e) => e.offsetParent !== null &&
      !e.closest(".legend")).map((e) => e.className || e.tagName));
  check(shown.length === 0, `${name} on paper: controls are left: ${shown.slice(0, 5).join(" ")}`);
  const pdf = await page.pdf({preferCSSPageSize: true, printBackground: false});
  const pages = (Buffer.from(pdf).toString("latin1").match(/\/Type\s*\/Page\b/g) ?? []).length;
  check(pages > 0 && pages < 40, `${name} on paper: ${pages} pages`);
  await page.emulateMediaType("screen");
}

async function lookAt(browser, file, thorough) {
  const name = path.basename(path.dirname(path.resolve(file)));
  const views = [[1400, "light"], [390, "dark"]];
  if (thorough) views.push([390, "light"], [1400, "dark"]);
  for (const [width, scheme] of views) {
    const watch = {messages: [], requests: []};
    const label = `${name} at ${width} px, ${scheme}`;
    const page = await openReport(browser, file, width, scheme, watch);
    const empty = await page.evaluate(findEmptyFigures);
    check(empty.length === 0, `${label}: empty figures: ${empty.join(" | ")}`);
    const wide = await page.evaluate(findOverflow);
    check(wide.length === 0, `${label}: beyond the page: ${wide.slice(0, 5).join(" | ")}`);
    const cut = await page.evaluate(findCutTexts);
    check(cut.length === 0, `${label}: texts cut off: ${cut.slice(0, 5).join(" | ")}`);
    const weak = await page.evaluate(findWeakContrast);
    check(weak.length === 0, `${label}: weak contrast: ${weak.slice(0, 5).join(" | ")}`);
    if (thorough) {
      await page.screenshot({path: path.join(pictures, `${name}-${width}-${scheme}.png`),
        fullPage: true});
    }
    if (width === 1400 && scheme === "light") {
      await tryControls(page, name);
      await tryShapes(page, name);
      const data = await tryData(page, name);
      check(data.without.every((kind) => kind !== "series" && kind !== "xy" && kind !== "heat" &&
        kind !== "plan" && kind !== "shape"), `${name}: plots without data: ${data.without.join(" ")}`);
      await tryPaper(page, name);
      await page.evaluate(() => document.querySelectorAll("details").forEach((d) => { d.open = true; }));
      await new Promise((resolve) => setTimeout(resolve, 300));
      const unfolded = await page.evaluate(findEmptyFigures);
      check(unfolded.length === 0, `${label}: empty when unfolded: ${unfolded.join(" | ")}`);
    }
    check(watch.messages.length === 0, `${label}: console: ${watch.messages.join(" | ")}`);
    check(watch.requests.length === 0, `${label}: asks the network: ${watch.requests.join(" | ")}`);
    await page.close();
  }
}

mkdirSync(pictures, {recursive: true});
await withBrowser(modules, async (browser) => {
  for (const report of reports) await lookAt(browser, report, report === reports[0]);
});
console.log(`${checked.count - checked.failures.length} passed, ${checked.failures.length} failed`);
process.exit(checked.failures.length === 0 && checked.count > 0 ? 0 : 1);
