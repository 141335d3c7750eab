// Curves over time or distance. Plots of one group share the zoom, the cursor and which curves are
// shown (by name).
"use strict";
(() => {
  const groups = {};  // group name → {plots: [], range: zoom or null, hidden: Set of names}
  let busy = false;   // true while a change of one plot is handed on to the others

  function groupOf(name) {
    return groups[name] ??= {plots: [], range: null, hidden: new Set()};
  }

  // The cursor of the plots over distance is that of the replay.
  const kShared = "distance";
  let told = false;  // true while the plots are moved from outside
  let next = null;
  /** Plots in the window only, and at most ten times a second: a running replay has no more time. */
  function moveCursors() {
    const x = next;
    next = null;
    if (x === null) return;
    told = true;
    for (const plot of groupOf(kShared).plots) {
      const box = plot.root.getBoundingClientRect();
      if (box.width === 0 || box.bottom < 0 || box.top > innerHeight) continue;
      const left = plot.valToPos(x, "x");
      const seen = left >= 0 && left <= plot.over.clientWidth;
      plot.setCursor(seen ? {left, top: plot.over.clientHeight / 2} : {left: -10, top: -10}, false);
    }
    told = false;
  }
  const cursor = phs.cursor.join((x) => {
    if (next === null) setTimeout(moveCursors, 100);
    next = x;
  });

  function zoom(group, least, greatest) {
    busy = true;
    group.range = least === undefined ? null : [least, greatest];
    for (const plot of group.plots) {
      plot.setScale("x", {min: least ?? plot.whole[0], max: greatest ?? plot.whole[1]});
    }
    busy = false;
  }

  function show(name, group, label, shown) {
    shown ? group.hidden.delete(label) : group.hidden.add(label);
    busy = true;
    for (const plot of group.plots) {
      plot.series.forEach((series, i) => {
        if (i > 0 && series.label === label && series.show !== shown) {
          plot.setSeries(i, {show: shown});
        }
      });
    }
    busy = false;
    for (const key of document.querySelectorAll(`.legend[data-group="${name}"] .key`)) {
      if (key.dataset.label === label) key.setAttribute("aria-pressed", String(shown));
    }
  }

  function drawBands(plot, bands) {
    const {ctx, bbox} = plot;
    const ratio = devicePixelRatio;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, 0, bbox.width, bbox.top + bbox.height);
    ctx.clip();
    ctx.font = `${11 * ratio}px system-ui, sans-serif`;
    ctx.textAlign = "center";
    for (const band of bands) {
      const left = plot.valToPos(band.begin, "x", true);
      const right = plot.valToPos(band.end, "x", true);
      ctx.fillStyle = phs.theme(band.strength > 1 ? "band-strong" : "band");
      ctx.fillRect(left, bbox.top, right - left, bbox.height);
      const from = Math.max(left, bbox.left);
      const to = Math.min(right, bbox.left + bbox.width);
      if (band.label && to - from > ctx.measureText(band.label).width + 6 * ratio) {
        ctx.fillStyle = phs.theme("faint");
        ctx.fillText(band.label, (from + to) / 2, bbox.top - 4 * ratio);
      }
    }
    ctx.restore();
  }

  function drawLevels(plot, levels) {
    const {ctx, bbox} = plot;
    const ratio = devicePixelRatio;
    ctx.save();
    ctx.font = `${11 * ratio}px system-ui, sans-serif`;
    ctx.strokeStyle = ctx.fillStyle = phs.theme("warn");
    ctx.lineWidth = ratio;
    ctx.setLineDash([6 * ratio, 4 * ratio]);
    for (const level of levels) {
      const y = plot.valToPos(level.value, "y", true);
      if (y < bbox.top || y > bbox.top + bbox.height) continue;
      ctx.beginPath();
      ctx.moveTo(bbox.left, y);
      ctx.lineTo(bbox.left + bbox.width, y);
      ctx.stroke();
      ctx.fillText(level.label, bbox.left + 4 * ratio, y - 4 * ratio);
    }
    ctx.restore();
  }

  function ordinateRange(spec) {
    return (plot, least, greatest) => {
      if (least === null || greatest === null) return [0, 1];
      const {min, max} = plot.scales.x;
      const [first, last] = plot.whole ?? [min, max];
      const slack = 2e-3 * (last - first);  // plots of one group need not begin at the same row
      const whole = !(min > first + slack || max < last - slack);
      if (spec.ordinate && whole) [least, greatest] = spec.ordinate;
      if (spec.from_zero) least = Math.min(least, 0);
      const lack = spec.least_span - (greatest - least);
      if (lack > 0) {
        greatest += spec.from_zero ? lack : lack / 2;
        least -= spec.from_zero ? 0 : lack / 2;
      }
      const margin = (greatest - least || Math.abs(greatest) || 1) * 0.06;
      return [spec.from_zero && least === 0 ? 0 : least - margin, greatest + margin];
    };
  }

  /** Room for the tick labels of an ordinate. */
  function axisWidth(plot, values, axis, cycle) {
    if (cycle > 1) return plot.axes[axis]._size;
    const longest = (values ?? []).reduce((n, text) => Math.max(n, text.length), 0);
    return 18 + longest * 7;
  }

  phs.plotAxis = (label, ordinate) => ({
    label,
    labelSize: 18,
    labelFont: "12px system-ui, sans-serif",
    font: "12px system-ui, sans-serif",
    stroke: () => phs.theme("text"),
    grid: {stroke: () => phs.theme("grid"), width: 1},
    ticks: {stroke: () => phs.theme("rule"), width: 1, size: 5},
    values: (plot, marks) => marks.map((mark) => mark === null ? "" : phs.number(mark, 6)),
    ...(ordinate ? {size: axisWidth} : {size: 34, space: 60}),
  });

  function options(spec, width, group) {
    const curve = (c) => ({
      label: c.label,
      stroke: () => phs.colour(c.colour),
      width: 1.6,
      dash: phs.dashes[c.dash],
      spanGaps: false,
      points: c.points ? {show: true, size: 6, fill: () => phs.colour(c.colour)} : {show: false},
      paths: c.points ? () => null : spec.steps ? uPlot.paths.stepped({align: 1}) : undefined,
      show: !group.hidden.has(c.label),
      value: (plot, value) => phs.number(value),
    });
    return {
      width,
      height: spec.height,
      padding: [spec.bands.length > 0 ? 18 : 8, 8, 0, 0],
      scales: {x: {time: false}, y: {range: ordinateRange(spec)}},
      axes: [phs.plotAxis(spec.x_label, false), phs.plotAxis(spec.y_label, true)],
      series: [{label: spec.x_label, value: (plot, value) => phs.number(value)},
        ...spec.curves.map(curve)],
      cursor: {
        drag: {x: true, y: false},
        points: {size: 6},
        sync: {key: "phs-" + spec.group, setSeries: false,
          filters: {pub: (kind) => kind === "mousemove" || kind === "mouseleave"}},
      },
      legend: {markers: {
        fill: (plot, i) => i > 0 ? `var(--c${spec.curves[i - 1].colour})` : "transparent"}},
      hooks: {
        drawClear: [(plot) => drawBands(plot, spec.bands)],
        draw: [(plot) => drawLevels(plot, spec.levels)],
        setScale: [(plot, scale) => {
          if (scale !== "x" || busy || !plot.ready) return;
          zoom(group, plot.scales.x.min, plot.scales.x.max);
        }],
        setCursor: [(plot) => {
          const {left} = plot.cursor;
          if (told || spec.group !== kShared || !(left >= 0) || !plot.over.matches(":hover")) return;
          cursor.move(plot.posToVal(left, "x"));
        }],
        setSeries: [(plot, i, change) => {
          if (busy || i === null || change.show === undefined || change.show === null) return;
          show(spec.group, group, plot.series[i].label, change.show);
        }],
      },
    };
  }

  function describe(spec, ys) {
    const parts = spec.curves.map((curve, i) => {
      const known = ys[i].filter((y) => y !== null);
      if (known.length === 0) return `${curve.label}: no data`;
      const least = known.reduce((a, b) => Math.min(a, b));
      const greatest = known.reduce((a, b) => Math.max(a, b));
      return `${curve.label}: ${phs.number(least, 3)} to ${phs.number(greatest, 3)}`;
    });
    return `${spec.y_label} over ${spec.x_label}. ${parts.join("; ")}.`;
  }

  phs.painters.series = (place, spec, figure) => {
    const {grid} = spec;
    const x = spec.x ?? Array.from({length: grid.points},
      (_, i) => grid.begin + (i + 0.5) * (grid.end - grid.begin) / grid.points);
    const ys = spec.curves.map((curve) => phs.unpack(curve.y));
    const group = groupOf(spec.group);
    figure.dataset.group = spec.group;
    let plot = null;
    phs.onWidth(place, (width) => {
      if (plot) {
        plot.setSize({width, height: spec.height});
        return;
      }
      plot = new uPlot(options(spec, width, group), [x, ...ys], place);
      plot.whole = [x[0], x[x.length - 1]];
      plot.ready = true;
      group.plots.push(plot);
      if (group.range) {  // drawn late (a fold was opened): join the others
        busy = true;
        plot.setScale("x", {min: group.range[0], max: group.range[1]});
        busy = false;
      }
      figure.plot = plot;
      const wrap = place.querySelector(".u-wrap");
      wrap.setAttribute("role", "img");
      wrap.setAttribute("aria-label", describe(spec, ys));
    });
    phs.recolour.push(() => plot?.redraw(false, false));
  };

  phs.connectControls = () => {
    for (const bar of document.querySelectorAll(".zoom")) {
      bar.addEventListener("click", ({target}) => {
        if (target.tagName !== "BUTTON") return;
        const {begin, end} = target.dataset;
        const group = groupOf(bar.dataset.group);
        begin === undefined ? zoom(group) : zoom(group, Number(begin), Number(end));
      });
    }
    for (const bar of document.querySelectorAll(".legend")) {
      bar.addEventListener("click", ({target}) => {
        const key = target.closest(".key");
        if (!key) return;
        const shown = key.getAttribute("aria-pressed") !== "true";
        show(bar.dataset.group, groupOf(bar.dataset.group), key.dataset.label, shown);
      });
    }
  };
})();
