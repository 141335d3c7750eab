// A shape that swings, seen from above: play, or move the phase. All shapes of a page share one
// phase. The complex motion of each point comes with the page; here it is only turned:
// r + Re(m) cos(phi) - Im(m) sin(phi). Nothing runs before the reader says so, and where less motion
// is asked for, the button goes on by a twelfth of a period.
"use strict";
(() => {
  const kStep = 30;  // degrees
  const kTallest = 340, kMargin = 14, kFoot = 26;  // px
  const still = matchMedia("(prefers-reduced-motion: reduce)");

  /** The phase [degrees] of all shapes: whoever changes it tells every picture. */
  const clock = {
    phase: 0, running: false, period: 4, pictures: [],
    tell() { for (const draw of this.pictures) draw(); },
    set(phase) {
      this.phase = ((phase % 360) + 360) % 360;
      this.tell();
    },
    press() {
      if (still.matches && !this.running) return this.set(Math.round(this.phase / kStep + 1) * kStep);
      this.running = !this.running;
      this.tell();
      if (!this.running) return;
      let before = performance.now();
      const next = (now) => {
        if (!this.running) return;
        if (still.matches) this.running = false;
        // A page that was out of sight goes on where it was.
        this.set(this.phase + 360 * Math.min(0.1, Math.max(0, now - before) / 1000) / this.period);
        before = now;
        requestAnimationFrame(next);
      };
      requestAnimationFrame(next);
    },
  };

  const swing = ([re, im], phase) =>
    re * Math.cos(phase * Math.PI / 180) - im * Math.sin(phase * Math.PI / 180);
  const placeOf = (point, phase) => [point.x + swing(point.dx, phase), point.y + swing(point.dy, phase)];
  phs.placeOfShape = placeOf;

  function extent(lines) {
    const box = {left: Infinity, right: -Infinity, low: Infinity, high: -Infinity};
    for (const {from, to} of lines) {
      for (const p of [from, to]) {
        const [x, y] = [Math.hypot(...p.dx), Math.hypot(...p.dy)];
        box.left = Math.min(box.left, p.x - x);
        box.right = Math.max(box.right, p.x + x);
        box.low = Math.min(box.low, p.y - y);
        box.high = Math.max(box.high, p.y + y);
      }
    }
    return box;
  }

  function picture(spec, title, width) {
    const box = extent(spec.lines);
    const scale = Math.min((width - 2 * kMargin) / (box.right - box.left || 1),
      (kTallest - 2 * kMargin - kFoot) / (box.high - box.low || 1));
    const height = Math.round((box.high - box.low) * scale + 2 * kMargin + kFoot);
    const shift = (width - (box.right - box.left) * scale) / 2;
    const view = phs.svg("svg", {width, height, viewBox: `0 0 ${width} ${height}`, role: "img",
      "font-size": 12, "aria-label": title});
    const path = ({from, to}, phase) => [from, to].map((p, i) => {
      const [x, y] = placeOf(p, phase);
      return `${i ? "L" : "M"}${(shift + (x - box.left) * scale).toFixed(2)} ` +
        (kMargin + (box.high - y) * scale).toFixed(2);
    }).join("");
    const style = (key, more) => `fill: none; stroke-linecap: round; stroke: var(--c${key.colour}); ` +
      `stroke-dasharray: ${phs.dashes[key.dash].join(" ") || "none"}; ${more}`;
    for (const line of spec.lines.filter((one) => one.trace)) {
      for (const phase of spec.traces_deg) {
        view.append(phs.svg("path", {d: path(line, phase),
          style: style(spec.keys[line.key], "stroke-width: 1; stroke-opacity: .45")}));
      }
    }
    const moving = spec.lines.map((line) => {
      const element = phs.svg("path", {class: "moves"}, phs.svg("title", {}, line.name));
      view.append(element);
      return {line, element};
    });
    const foot = height - 8;
    view.append(phs.svg("path", {d: `M${kMargin} ${foot - 5}v5h${scale.toFixed(1)}v-5`,
      style: "fill: none; stroke: var(--text)"}),
    phs.svg("text", {x: kMargin + scale + 6, y: foot}, "1 m"),
    phs.svg("text", {x: width - kMargin, y: foot, "text-anchor": "end"}, "forward →"));
    return {view, turn(phase) {
      for (const {line, element} of moving) {
        const shorter = line.stroke && swing(line.stroke, phase) < 0 ? 1 : 0;
        element.setAttribute("d", path(line, phase));
        element.setAttribute("style", style(spec.keys[line.key + shorter], `stroke-width: ${line.width}`));
      }
    }};
  }

  phs.painters.shape = (place, spec, figure) => {
    const title = figure.querySelector("figcaption").textContent;
    const button = phs.html("button", {type: "button", class: "play"});
    const slider = phs.html("input", {type: "range", min: 0, max: 360, step: 1, value: 0,
      "aria-label": `phase of ${title}`});
    const output = phs.html("output");
    const room = phs.html("div");
    place.append(phs.html("div", {class: "bar"}, button, slider, output), room,
      phs.html("div", {class: "keys"}, ...spec.keys.map((key) => phs.html("span",
        {class: `key c${key.colour} d${key.dash}`}, phs.html("i"), key.label))));
    let drawn = null;
    const draw = () => {
      const words = clock.running ? "❚❚ Pause" : still.matches ? "▶ Next step" : "▶ Play";
      if (button.textContent !== words) button.textContent = words;
      if (!(clock.phase === 0 && slider.value === "360")) slider.value = clock.phase;
      output.textContent = `phase ${Math.round(clock.phase) % 360}°`;
      figure.dataset.phase = clock.phase;
      drawn?.turn(clock.phase);
    };
    clock.pictures.push(draw);
    clock.period = spec.period_s;
    button.addEventListener("click", () => clock.press());
    slider.addEventListener("input", () => clock.set(Number(slider.value)));
    still.addEventListener("change", draw);
    phs.onWidth(room, (width) => {
      drawn = picture(spec, title, width);
      room.replaceChildren(drawn.view);
      draw();
    });
  };
})();
