// Draws every figure of the page, the first ones at once and the rest as soon as the page is idle.
"use strict";
(() => {
  const specs = JSON.parse(document.getElementById("figures").textContent);
  const figures = [...document.querySelectorAll("figure.plot")];
  const paint = (figure) => {
    phs.painters[figure.dataset.kind](figure.querySelector(".drawing"), specs[figure.id], figure);
    figure.dataset.drawn = "yes";
  };
  phs.connectControls();
  figures.slice(0, 4).forEach(paint);
  performance.mark("phs-first");  // the first table and plots are there: how long it takes is tested
  const rest = figures.slice(4);
  const finish = () => {
    document.documentElement.dataset.ready = "yes";
    for (const work of phs.afterwards) setTimeout(work, 0);
  };
  const next = () => {
    rest.splice(0, 4).forEach(paint);
    if (rest.length > 0) setTimeout(next, 0);
    else finish();
  };
  setTimeout(next, 0);
})();
