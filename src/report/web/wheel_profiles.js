// Wheel and rail in section at the cursor: the profiles as they are used, each contact patch with its
// pressure over its width, and the patches seen from above.
"use strict";
(() => {
  const kSpan = 0.096;     // shown across [m]
  const kHeight = 0.062;   // shown in section [m]
  const kTop = 0.026;      // of it above the rail top [m]
  const kPressure = 0.012e-9;  // height of the pressure in the drawing [m/Pa]
  const kPatch = 1.6;      // patches from above are so much larger than the section
  const round = (value) => Number(value.toFixed(2));

  const known = (value) => value !== null && !Number.isNaN(value);
  const at = (course, row) => typeof course === "number" ? course : course?.[row] ?? NaN;
  const patchesAt = (wheel, row) => wheel.patches
    .map((patch) => patch.map((course) => at(course, row)))
    .map(([y, z, angle, a, b, pressure, load, share]) => ({y, z, angle, a, b, pressure, load, share}))
    .filter(({load}) => known(load) && load > 0);

  const words = (patches) => patches.length === 0 ? "The wheel carries nothing here."
    : patches.map(({a, b, pressure, load, angle, share}) => (share < 0.995
      ? `two patches grow into one, ${phs.number(100 * share, 2)} % of: ` : "") +
      `${phs.number(load / 1e3, 3)} kN on an ellipse of ` +
      `${phs.number(2e3 * a, 2)} × ${phs.number(2e3 * b, 2)} mm, at most ${phs.number(pressure / 1e6, 3)} MPa, ` +
      `slope ${phs.number(Math.abs(angle) * 180 / Math.PI, 2)}°`).join("; ") + ".";

  /** Red where steel yields in shakedown's neighbourhood (2 GPa), else from the theme's cold to hot. */
  const fill = (pressure) =>
    `color-mix(in srgb, var(--hot) ${Math.round(100 * Math.min(1, pressure / 2e9))}%, var(--c4))`;

  function drawWheel(bogie, wheel, row, width, hand) {
    const patches = patchesAt(wheel, row);
    const scale = width / kSpan;
    const section = Math.round(kHeight * scale);
    const above = Math.round(section + 0.024 * scale * kPatch + 24);
    const picture = phs.svg("svg", {width, height: above, viewBox: `0 0 ${width} ${above}`, role: "img",
      "font-size": 12, "aria-label": `${bogie.title}, ${wheel.name}: ${words(patches)}`});
    // Looked at along the track: the left wheel's field side lies to the left.
    const px = ([y, z]) => [round(width / 2 - hand * y * scale), round((z + kTop) * scale)];
    const path = (points, style, closed = true) => picture.append(phs.svg("path", {style,
      d: points.map((p, i) => (i ? "L" : "M") + px(p).join(" ")).join("") + (closed ? "Z" : "")}));
    const clip = `clip-${Math.random().toString(36).slice(2)}`;
    picture.append(phs.svg("clipPath", {id: clip}, phs.svg("rect", {width, height: section})));
    const inside = phs.svg("g", {"clip-path": `url(#${clip})`});
    path(bogie.rail, "fill: var(--steel-low); stroke: var(--faint); stroke-width: 1.2");
    const dy = at(wheel.y, row);
    if (known(dy)) {
      const dz = at(wheel.z, row);
      const roll = at(wheel.roll, row);
      const c = Math.cos(roll);
      const s = Math.sin(roll);
      path(bogie.wheel.map(([y, z]) => [dy + c * y - s * z, dz + s * y + c * z]),
        "fill: var(--steel-high); stroke: var(--faint); stroke-width: 1.2");
    }
    inside.append(...picture.querySelectorAll("path"));
    picture.append(inside);
    for (const patch of patches) {
      // The pressure stands on the surface: half an ellipse as wide as the patch.
      const along = [Math.cos(patch.angle), -Math.sin(patch.angle)];
      const out = [-Math.sin(patch.angle), -Math.cos(patch.angle)];  // of the rail
      const height = patch.pressure * kPressure;
      const arc = [];
      for (let i = 0; i <= 24; ++i) {
        const t = Math.PI * i / 24;
        const u = patch.b * Math.cos(t);
        const v = height * Math.sin(t);
        arc.push([0, 1].map((k) => [patch.y, patch.z][k] + u * along[k] + v * out[k]));
      }
      path(arc, `fill: ${fill(patch.pressure)}; fill-opacity: .85; stroke: var(--text); stroke-width: .8`);
      path([[patch.y - patch.b * along[0], patch.z - patch.b * along[1]],
        [patch.y + patch.b * along[0], patch.z + patch.b * along[1]]],
      "stroke: var(--text); stroke-width: 3; fill: none", false);
    }
    const middle = section + (above - section) / 2;
    for (const patch of patches) {
      const [x] = px([patch.y, 0]);
      picture.append(phs.svg("ellipse", {cx: x, cy: round(middle), rx: round(patch.b * scale * kPatch),
        ry: round(patch.a * scale * kPatch),
        style: `fill: ${fill(patch.pressure)}; stroke: var(--text); stroke-width: 1`}));
    }
    picture.append(phs.svg("text", {x: 4, y: above - 6, style: "fill: var(--faint)"}, `from above, ${kPatch} ×`));
    const bar = 0.01 * scale;
    picture.append(phs.svg("path", {d: `M${round(width - 6 - bar)} ${section - 5}h${round(bar)}`,
      style: "stroke: var(--text); stroke-width: 2"}),
    phs.svg("text", {x: round(width - 6), y: section - 10, "text-anchor": "end"}, "10 mm"));
    return phs.html("div", {}, phs.html("strong", {}, `${bogie.title}, leading ${wheel.name}`), picture,
      phs.html("p", {}, words(patches)));
  }

  phs.painters.profiles = (place, spec, figure) => {
    phs.afterwards.push(() => {
      const film = phs.film.get();
      const bogies = film.bogies.filter((bogie) => bogie.wheels.length > 0);
      const views = phs.html("div", {class: "wheels"});
      place.append(views);
      let s = film.start;
      const draw = () => {
        const row = phs.film.moment(s).nearest;
        const cells = bogies.flatMap((bogie) => bogie.wheels.map((wheel, i) => [bogie, wheel, i === 0 ? 1 : -1]));
        if (views.children.length !== cells.length) views.replaceChildren(...cells.map(() => phs.html("div")));
        const widths = [...views.children].map((cell) => Math.floor(cell.clientWidth));
        views.replaceChildren(...cells.map(([bogie, wheel, hand], i) =>
          drawWheel(bogie, wheel, row, Math.max(120, widths[i]), hand)));
        figure.dataset.place = s;
      };
      let waiting = null;
      phs.cursor.join((x) => {
        s = Math.max(film.begin, Math.min(film.end, x));
        waiting ??= setTimeout(() => {
          waiting = null;
          draw();
        }, 60);
      });
      phs.onWidth(place, draw);
    });
  };
})();
