// A value over a grid of cells, with its colour scale.
"use strict";
(() => {
  const mix = (a, b, part) => `color-mix(in srgb, var(--${b}) ${(100 * part).toFixed(1)}%, var(--${a}))`;

  /** Colour of a value on a scale [least, greatest]; a diverging scale is symmetric about zero. */
  function colourOf(value, [least, greatest], diverging) {
    if (!diverging) return mix("mid", "cold", (value - least) / (greatest - least || 1));
    return mix("mid", value < 0 ? "cold" : "hot", Math.min(1, Math.abs(value) / greatest));
  }

  function draw(place, spec, width) {
    const {x_edges: xs, y_edges: ys, values} = spec;
    const height = Math.round(Math.min(340, Math.max(220, width * 0.6)));
    const box = {left: 62, top: 8, right: width - 84, bottom: height - 42};
    const toX = (x) => box.left + (x - xs[0]) / (xs[xs.length - 1] - xs[0]) * (box.right - box.left);
    const toY = (y) => box.bottom - (y - ys[0]) / (ys[ys.length - 1] - ys[0]) * (box.bottom - box.top);
    const known = values.flat().filter((value) => value !== null);
    let least = known.reduce((a, b) => Math.min(a, b), Infinity);
    let greatest = known.reduce((a, b) => Math.max(a, b), -Infinity);
    if (known.length === 0) least = greatest = 0;
    const most = spec.full_scale || Math.max(Math.abs(least), Math.abs(greatest)) || 1;
    const scale = spec.diverging ? [-most, most] : [least, greatest];
    const picture = phs.svg("svg", {width, height, viewBox: `0 0 ${width} ${height}`, role: "img",
      "font-size": 12, "aria-label": `${spec.value_label} over ${spec.x_label} and ${spec.y_label}: ` +
        `${phs.number(least, 3)} to ${phs.number(greatest, 3)}`});
    const label = (x, y, text, anchor = "middle", turn = null) => picture.append(
      phs.svg("text", {x, y, "text-anchor": anchor, transform: turn}, text));
    values.forEach((row, j) => row.forEach((value, i) => {
      if (value === null) return;
      picture.append(phs.svg("rect", {
        x: toX(xs[i]), y: toY(ys[j + 1]),
        width: Math.max(0, toX(xs[i + 1]) - toX(xs[i]) + 0.5),
        height: Math.max(0, toY(ys[j]) - toY(ys[j + 1]) + 0.5),
        style: `fill: ${colourOf(value, scale, spec.diverging)}`},
      phs.svg("title", {}, `${spec.x_label}: ${phs.number(xs[i], 3)} … ${phs.number(xs[i + 1], 3)}, ` +
        `${spec.y_label}: ${phs.number(ys[j], 3)} … ${phs.number(ys[j + 1], 3)}: ${phs.number(value, 3)}`)));
    }));
    picture.append(phs.svg("rect", {x: box.left, y: box.top, width: box.right - box.left,
      height: box.bottom - box.top, style: "fill: none; stroke: var(--rule)"}));
    for (const x of phs.ticks(xs[0], xs[xs.length - 1], (box.right - box.left) / 70)) {
      label(toX(x), box.bottom + 16, phs.number(x));
    }
    for (const y of phs.ticks(ys[0], ys[ys.length - 1], 5)) {
      label(box.left - 5, toY(y) + 4, phs.number(y), "end");
    }
    label((box.left + box.right) / 2, height - 6, spec.x_label);
    label(13, (box.top + box.bottom) / 2, spec.y_label, "middle",
      `rotate(-90 13 ${(box.top + box.bottom) / 2})`);
    const steps = 24;
    for (let k = 0; k < steps; ++k) {
      const value = scale[0] + (k + 0.5) / steps * (scale[1] - scale[0]);
      const stripe = (box.bottom - box.top) / steps;
      picture.append(phs.svg("rect", {x: box.right + 10, y: box.bottom - (k + 1) * stripe, width: 12,
        height: stripe + 0.5, style: `fill: ${colourOf(value, scale, spec.diverging)}`}));
    }
    for (const value of phs.ticks(scale[0], scale[1], 4)) {
      const part = (value - scale[0]) / (scale[1] - scale[0] || 1);
      label(box.right + 26, box.bottom - part * (box.bottom - box.top) + 4, phs.number(value, 3), "start");
    }
    label(width - 12, (box.top + box.bottom) / 2, spec.value_label, "middle",
      `rotate(90 ${width - 12} ${(box.top + box.bottom) / 2})`);
    place.replaceChildren(picture);
  }

  phs.painters.heat = (place, spec) => phs.onWidth(place, (width) => draw(place, spec, width));
})();
