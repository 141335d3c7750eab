// The bogie seen from above on its track, with all angles magnified by the same factor (as if the
// radius were that much smaller), and the map of the whole track. A slider moves along the track.
"use strict";
(() => {
  const round = (value) => Number(value.toFixed(2));

  /** The track near the bogie: a circle through the origin with curvature k, heading along x. */
  function onCircle(k, along) {
    const heading = k * along;
    if (Math.abs(heading) < 1e-9) return {x: along, y: 0, heading};
    return {x: Math.sin(heading) / k, y: (1 - Math.cos(heading)) / k, heading};
  }
  const aside = (place, left) => ({
    x: place.x - left * Math.sin(place.heading),
    y: place.y + left * Math.cos(place.heading),
    heading: place.heading,
  });

  /** An SVG in metres, x to the right = direction of travel, y up = left. */
  function canvas(width, length, height, label) {
    const scale = width / length;
    const picture = phs.svg("svg", {width, height: Math.round(height * scale), role: "img",
      "aria-label": label, viewBox: `0 0 ${width} ${Math.round(height * scale)}`, "font-size": 12});
    const px = (p) => [round((p.x + length / 2) * scale), round((height / 2 - p.y) * scale)];
    const path = (points, style, closed = false) => picture.append(phs.svg("path", {
      d: points.map((p, i) => (i ? "L" : "M") + px(p).join(" ")).join("") + (closed ? "Z" : ""),
      style: `fill: none; ${style}`}));
    const text = (p, words, anchor = "middle", style = "") => {
      const [x, y] = px(p);
      picture.append(phs.svg("text", {x, y, "text-anchor": anchor, style}, words));
    };
    return {picture, px, path, text};
  }

  /** Corners of a rectangle centred at `at`, `length` along its heading. */
  function rectangle(at, length, breadth) {
    const c = Math.cos(at.heading);
    const s = Math.sin(at.heading);
    return [[1, 1], [1, -1], [-1, -1], [-1, 1]].map(([i, j]) => ({
      x: at.x + i * length / 2 * c - j * breadth / 2 * s,
      y: at.y + i * length / 2 * s + j * breadth / 2 * c,
    }));
  }

  function drawBogie(spec, bogie, row, width) {
    const {magnification: angles, lateral_magnification: offsets} = spec;
    const half = spec.wheelbase / 2;
    const k = (spec.curvature[row] ?? 0) * angles;
    const length = spec.wheelbase * 1.95;
    const view = canvas(width, length, length * 0.62,
      `${bogie.label}: leading axle ${phs.number(1e3 * bogie.lead.attack[row], 3)} mrad from radial, ` +
      `trailing axle ${phs.number(1e3 * bogie.trail.attack[row], 3)} mrad`);
    const colour = `var(--c${bogie.colour})`;
    for (const side of [-1, 1]) {
      const rail = [];
      for (let along = -0.56 * length; along <= 0.56 * length; along += length / 60) {
        rail.push(aside(onCircle(k, along), side * spec.gauge / 2));
      }
      view.path(rail, "stroke: var(--faint); stroke-width: 3");
    }
    const axles = [["lead", half], ["trail", -half]].map(([name, along]) => {
      const foot = onCircle(k, along);
      view.path([aside(foot, 0.95 * spec.gauge), aside(foot, -0.95 * spec.gauge)],
        "stroke: var(--faint); stroke-width: 1; stroke-dasharray: 5 4");
      const axle = aside(foot, (bogie[name].lateral[row] ?? 0) * offsets);
      axle.heading = foot.heading + (bogie[name].attack[row] ?? 0) * angles;
      axle.frame = axle.heading - (bogie[name].yaw[row] ?? 0) * angles;
      return axle;
    });
    const frame = {x: (axles[0].x + axles[1].x) / 2, y: (axles[0].y + axles[1].y) / 2,
      heading: (axles[0].frame + axles[1].frame) / 2};
    for (const side of [-1, 1]) {
      view.path(rectangle(aside(frame, side * spec.gauge * 0.76), spec.wheelbase * 1.16, 0.1),
        "stroke: var(--text); stroke-width: 1; fill: var(--card)", true);
    }
    view.path(rectangle(frame, 0.36, spec.gauge * 1.42),
      "stroke: var(--text); stroke-width: 1; fill: var(--card)", true);
    for (const axle of axles) {
      view.path([aside(axle, spec.gauge * 0.82), aside(axle, -spec.gauge * 0.82)],
        `stroke: ${colour}; stroke-width: 5`);
      for (const side of [-1, 1]) {
        view.path(rectangle(aside(axle, side * (spec.gauge / 2 + 0.035)), 2 * spec.wheel_radius, 0.13),
          `stroke: ${colour}; stroke-width: 1.5; fill: var(--ground); fill-opacity: .55`, true);
      }
    }
    view.text({x: length * 0.47, y: -length * 0.28}, "travel →", "end", "fill: var(--faint)");
    const words = (name, title) => `${title} ${phs.number(1e3 * bogie[name].attack[row], 3)} mrad from ` +
      `radial, ${phs.number(1e3 * bogie[name].lateral[row], 3)} mm aside`;
    return phs.html("div", {}, phs.html("strong", {}, bogie.label), view.picture,
      phs.html("p", {}, `${words("lead", "Leading axle")}; ${words("trail", "trailing axle")}.`));
  }

  /** The map: centre line coloured by section, with a mark at arc length s. */
  function drawMap(spec, s, width) {
    const {x, y, s: arc} = spec.track;
    const least = {x: Math.min(...x), y: Math.min(...y)};
    const most = {x: Math.max(...x), y: Math.max(...y)};
    const margin = 26;
    const across = most.x - least.x || 1;
    const up = most.y - least.y;
    const scale = Math.min((width - 2 * margin) / across, 300 / Math.max(up, 1e-9));
    const height = Math.round(up * scale + 2 * margin + 24);
    const picture = phs.svg("svg", {width, height, viewBox: `0 0 ${width} ${height}`, role: "img",
      "font-size": 12, "aria-label": `Map of the track ${spec.track.name}`});
    const shift = (width - across * scale) / 2;
    const px = (i) => [round(shift + (x[i] - least.x) * scale), round(margin + (most.y - y[i]) * scale)];
    const line = (from, to, style) => {
      let d = "";
      for (let i = 0; i < arc.length; ++i) {
        const inside = arc[i] >= from - 1e-6 && arc[i] <= to + 1e-6;
        const next = i + 1 < arc.length && arc[i + 1] >= from && arc[i] < from;
        if (inside || next) d += (d ? "L" : "M") + px(i).join(" ");
      }
      if (d) picture.append(phs.svg("path", {d, style: "fill: none; stroke-linecap: round; " + style}));
    };
    const nearest = (at) => arc.reduce((best, value, i) =>
      Math.abs(value - at) < Math.abs(arc[best] - at) ? i : best, 0);
    line(arc[0], arc[arc.length - 1], "stroke: var(--faint); stroke-width: 3");
    for (const section of spec.track.sections) {
      if (section.kind === "curve") line(section.begin, section.end, "stroke: var(--c0); stroke-width: 5");
      if (section.kind === "transition") line(section.begin, section.end, "stroke: var(--c5); stroke-width: 4");
    }
    for (const section of spec.track.sections) {
      if (section.kind !== "curve") continue;
      const [cx, cy] = px(nearest((section.begin + section.end) / 2));
      picture.append(phs.svg("text", {x: cx, y: cy + 20, "text-anchor": "middle"}, section.label));
    }
    const [mx, my] = px(nearest(s));
    picture.append(phs.svg("circle", {cx: mx, cy: my, r: 7, style: "fill: var(--c1); stroke: var(--ground); stroke-width: 2"}));
    const bar = phs.ticks(0, across / 4, 1).pop() || across / 4;
    const [bx, by] = [shift, height - 8];
    picture.append(phs.svg("path", {d: `M${bx} ${by - 5}v5h${round(bar * scale)}v-5`, style: "fill: none; stroke: var(--text)"}),
      phs.svg("text", {x: round(bx + bar * scale + 6), y: by}, `${phs.number(bar)} m`));
    return picture;
  }

  function decode(spec) {
    spec.curvature = phs.unpack(spec.curvature);
    for (const bogie of spec.bogies) {
      for (const name of ["lead", "trail"]) {
        for (const key of ["lateral", "attack", "yaw"]) bogie[name][key] = phs.unpack(bogie[name][key]);
      }
    }
  }

  phs.painters.plan = (place, spec, figure) => {
    decode(spec);
    const {grid} = spec;
    const rows = grid.points;
    const at = (row) => grid.begin + (row + 0.5) * (grid.end - grid.begin) / rows;
    const start = Math.round((spec.start - grid.begin) / (grid.end - grid.begin) * rows - 0.5);
    const slider = phs.html("input", {type: "range", min: 0, max: rows - 1,
      value: Math.max(0, Math.min(rows - 1, start)), "aria-label": "place along the track"});
    const output = phs.html("output");
    const views = phs.html("div", {class: "views" + (spec.bogies.length > 1 ? " many" : "")});
    const map = phs.html("div", {class: "map"});
    place.append(phs.html("label", {class: "slider"}, "Place along the track: ", output, slider), views, map);
    const draw = () => {
      const row = Number(slider.value);
      const k = spec.curvature[row] ?? 0;
      output.textContent = `${phs.number(at(row))} m, ` +
        (Math.abs(k) < 1e-6 ? "straight" : `R ${phs.number(Math.abs(1 / k), 4)} m to the ${k > 0 ? "left" : "right"}`);
      views.replaceChildren(...spec.bogies.map(() => phs.html("div")));
      const widths = [...views.children].map((cell) => cell.clientWidth);
      views.replaceChildren(...spec.bogies.map((bogie, i) => drawBogie(spec, bogie, row, widths[i])));
      map.replaceChildren(...(spec.track ? [drawMap(spec, at(row), map.clientWidth)] : []));
    };
    slider.addEventListener("input", draw);
    phs.onWidth(place, draw);
  };
})();
