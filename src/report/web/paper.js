// On paper plots are drawn anew at the width that they have there: shrunk pictures would have labels
// too small to read.
"use strict";
(() => {
  const kWhole = 700, kHalf = 340;  // px of an A4 page without its margins (origin.css)
  const plots = () => [...document.querySelectorAll("figure.plot")].filter((figure) => figure.plot);
  const place = (figure) => figure.querySelector(".drawing");
  addEventListener("beforeprint", () => {
    for (const figure of plots()) {
      const {plot} = figure;
      plot.screenSize ??= {width: plot.width, height: plot.height};
      const width = figure.closest(".grid") ? kHalf : kWhole;
      plot.setSize({width, height: Math.min(plot.height, 240)});
    }
  });
  addEventListener("afterprint", () => {
    for (const figure of plots()) {
      const {plot} = figure;
      if (!plot.screenSize) continue;
      plot.setSize({width: Math.floor(place(figure).clientWidth) || plot.screenSize.width,
        height: plot.screenSize.height});
      delete plot.screenSize;
    }
  });
})();
