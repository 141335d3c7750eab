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

  /** An SVG in metres, x to the right = direction of travel, y up = left; as high as its content. */
  function canvas(width, length, label) {
    const scale = width / length;
    const picture = phs.svg("svg", {width, role: "img", "aria-label": label, "font-size": 12});
    const reach = {least: Infinity, most: -Infinity};
    const px = (p) => [round((p.x + length / 2) * scale), round(-p.y * scale)];
    const path = (points, style, closed = false) => {
      for (const p of points) {
        if (Math.abs(p.x) > 0.52 * length) continue;
        reach.least = Math.min(reach.least, p.y);
        reach.most = Math.max(reach.most, p.y);
      }
      picture.append(phs.svg("path", {
        d: points.map((p, i) => (i ? "L" : "M") + px(p).join(" ")).join("") + (closed ? "Z" : ""),
        style: `fill: none; ${style}`}));
    };
    const text = (p, words, anchor = "middle", style = "") => {
      const [x, y] = px(p);
      picture.append(phs.svg("text", {x, y, "text-anchor": anchor, style}, words));
    };
    const finish = () => {
      const top = round(-reach.most * scale - 20);
      const height = round((reach.most - reach.least) * scale + 40);
      picture.setAttribute("viewBox", `0 ${top} ${width} ${height}`);
      picture.setAttribute("height", height);
      picture.append(phs.svg("text", {x: width - 2, y: top + height - 4, "text-anchor": "end",
        style: "fill: var(--faint)"}, "travel →"));
      return picture;
    };
    return {path, text, finish};
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

  /** "1.04 mrad to the outer rail"; without a curve "… to the left". */
  function describeAttack(attack, curvature) {
    const size = `${phs.number(Math.abs(1e3 * attack), 3)} mrad to the `;
    if (Math.abs(curvature) < 1e-6) return size + (attack >= 0 ? "left" : "right");
    return size + (attack * curvature < 0 ? "outer rail" : "inner rail");
  }

  /** Rails, and each axle's place, heading and that of the frame it stands in. */
  function placeAxles(spec, bogie, row) {
    const k = (spec.curvature[row] ?? 0) * spec.magnification;
    return [["lead", 1], ["trail", -1]].map(([name, end]) => {
      const foot = onCircle(k, end * spec.wheelbase / 2);
      const axle = aside(foot, (bogie[name].lateral[row] ?? 0) * spec.lateral_magnification);
      axle.foot = foot;
      axle.heading = foot.heading + (bogie[name].attack[row] ?? 0) * spec.magnification;
      axle.frame = axle.heading - (bogie[name].yaw[row] ?? 0) * spec.magnification;
      axle.label = phs.number(Math.abs(1e3 * bogie[name].attack[row]), 3) + " mrad";
      return axle;
    });
  }

  function drawFrame(view, spec, axles) {
    const frame = {x: (axles[0].x + axles[1].x) / 2, y: (axles[0].y + axles[1].y) / 2,
      heading: (axles[0].frame + axles[1].frame) / 2};
    const style = "stroke: var(--faint); stroke-width: 1; fill: var(--card)";
    for (const side of [-1, 1]) {
      view.path(rectangle(aside(frame, side * spec.gauge * 0.8), spec.wheelbase * 1.2, 0.13), style, true);
    }
    view.path(rectangle(frame, 0.4, spec.gauge * 1.47), style, true);
  }

  function drawAxle(view, spec, axle, colour) {
    for (const side of [-1, 1]) {
      view.path([axle, aside({...axle, heading: axle.foot.heading}, side * spec.gauge), aside(axle, side * spec.gauge)],
        `stroke: none; fill: ${colour}; fill-opacity: .35`, true);
    }
    view.path([aside(axle.foot, 1.12 * spec.gauge), aside(axle.foot, -1.12 * spec.gauge)],
      "stroke: var(--text); stroke-width: 1; stroke-dasharray: 5 4");
    view.path([aside(axle, spec.gauge), aside(axle, -spec.gauge)], `stroke: ${colour}; stroke-width: 5`);
    for (const side of [-1, 1]) {
      view.path(rectangle(aside(axle, side * (spec.gauge / 2 + 0.035)), 2 * spec.wheel_radius, 0.15),
        `stroke: ${colour}; stroke-width: 2; fill: var(--ground); fill-opacity: .6`, true);
    }
    const end = aside(axle.foot, 1.16 * spec.gauge);
    view.text(end, axle.label);
  }

  function drawBogie(spec, bogie, row, width) {
    const curvature = spec.curvature[row] ?? 0;
    const length = spec.wheelbase * 1.9;
    if (bogie.lead.attack[row] === null || bogie.trail.attack[row] === null) {
      return phs.html("div", {}, phs.html("strong", {}, bogie.label),
        phs.html("p", {}, "The run did not reach this place."));
    }
    const words = ["lead", "trail"].map((name, i) => `${i ? "trailing" : "Leading"} axle points ` +
      `${describeAttack(bogie[name].attack[row] ?? 0, curvature)}, stands ` +
      `${phs.number(Math.abs(1e3 * bogie[name].lateral[row]), 3)} mm to the ` +
      `${bogie[name].lateral[row] >= 0 ? "left" : "right"}`).join("; ") + ".";
    const view = canvas(width, length, `${bogie.label}: ${words}`);
    for (const side of [-1, 1]) {
      const rail = [];
      for (let along = -0.56 * length; along <= 0.56 * length; along += length / 60) {
        rail.push(aside(onCircle(curvature * spec.magnification, along), side * spec.gauge / 2));
      }
      view.path(rail, "stroke: var(--faint); stroke-width: 4");
    }
    const axles = placeAxles(spec, bogie, row);
    drawFrame(view, spec, axles);
    for (const axle of axles) drawAxle(view, spec, axle, `var(--c${bogie.colour})`);
    return phs.html("div", {}, phs.html("strong", {}, bogie.label), view.finish(),
      phs.html("p", {}, words));
  }

  /** The map: centre line coloured by section, with a mark at arc length s. */
  function drawMap(spec, s, width) {
    const {x, y, s: arc} = spec.track;
    const least = {x: Math.min(...x), y: Math.min(...y)};
    const most = {x: Math.max(...x), y: Math.max(...y)};
    const margin = 26;
    const across = most.x - least.x || 1;
    const up = most.y - least.y;
    const scale = Math.min((width - 2 * margin) / across, 210 / Math.max(up, 1e-9));
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
      const middle = nearest((section.begin + section.end) / 2);
      const [ax, ay] = px(nearest(section.begin));
      const [bx, by] = px(nearest(section.end));
      const [cx, cy] = px(middle);
      // Outside of the arc: from the chord's middle through the arc's middle.
      const out = [cx - (ax + bx) / 2, cy - (ay + by) / 2];
      const size = Math.hypot(...out) || 1;
      const across = out[0] / size;
      picture.append(phs.svg("text", {x: cx + 14 * across, y: cy + 4 + 18 * out[1] / size,
        "text-anchor": across > 0.5 ? "start" : across < -0.5 ? "end" : "middle"}, section.label));
    }
    const [mx, my] = px(nearest(s));
    picture.append(phs.svg("circle", {cx: mx, cy: my, r: 7, style: "fill: var(--c1); stroke: var(--ground); stroke-width: 2"}));
    const power = 10 ** Math.floor(Math.log10(across / 4));
    const bar = [5, 2, 1].map((k) => k * power).find((length) => length <= across / 4);
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
    const toRow = (x) => Math.max(0, Math.min(rows - 1,
      Math.round((x - grid.begin) / (grid.end - grid.begin) * rows - 0.5)));
    let waiting = null;  // the page draws other things first while the cursor runs
    const cursor = phs.cursor.join((x) => {
      slider.value = toRow(x);
      clearTimeout(waiting);
      waiting = setTimeout(draw, 60);
    });
    slider.addEventListener("input", () => {
      draw();
      cursor.move(at(Number(slider.value)));
    });
    phs.onWidth(place, draw);
  };
})();
