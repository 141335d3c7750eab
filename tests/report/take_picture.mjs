// Takes a picture of a report, e.g. for the documentation:
//
//   node take_picture.mjs NODE_MODULES_DIR REPORT.html OUT.png [WIDTH [FROM [HEIGHT]]]
//
// WIDTH in px (1400), FROM a heading of the report at which the picture starts (its top), HEIGHT in
// px (1150).
import {openReport, withBrowser} from "./browser.mjs";

const [modules, report, out, width = "1400", from = "", height = "1150"] = process.argv.slice(2);
if (!out) {
  console.error("usage: take_picture.mjs NODE_MODULES_DIR REPORT.html OUT.png [WIDTH [FROM [HEIGHT]]]");
  process.exit(2);
}
await withBrowser(modules, async (browser) => {
  const page = await openReport(browser, report, Number(width), "light");
  const {top, end} = await page.evaluate((words) => {
    const heading = [...document.querySelectorAll("h2, h3")].find((h) => h.textContent === words);
    return {top: heading ? heading.getBoundingClientRect().top + scrollY - 10 : 0,
      end: document.documentElement.scrollHeight};
  }, from);
  await page.screenshot({path: out, captureBeyondViewport: true,
    clip: {x: 0, y: top, width: Number(width), height: Math.min(Number(height), end - top)}});
});
