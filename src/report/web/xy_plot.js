// Curves and clouds of points in a plane: loops, scatter plots, root loci. Drag to zoom,
// double click to go back; the readout gives the coordinates under the pointer.
"use strict";
(() => {
  /** Draws one curve as a line through its rows, a row without neighbours as a marker, or all as markers. */
  function painter(curve) {
    return (plot, index) => {
      uPlot.orient(plot, index, (series, dataX, dataY, scaleX, scaleY, posX, posY, left, top, w, h) => {
        const [xs, ys] = plot.data[index];
        const {ctx} = plot;
        const ratio = devicePixelRatio;
        ctx.save();
        ctx.beginPath();
        ctx.rect(left, top, w, h);
        ctx.clip();
        ctx.strokeStyle = ctx.fillStyle = phs.colour(curve.colour);
        ctx.lineWidth = 1.4 * ratio;
        ctx.setLineDash(phs.dashes[curve.dash].map((d) => d * ratio));
        const there = (i) => (xs[i] ?? null) !== null && (ys[i] ?? null) !== null;
        const line = new Path2D(), markers = new Path2D();
        let pen = false;
        for (let i = 0; i < xs.length; ++i) {
          const alone = !there(i - 1) && !there(i + 1);
          if (!there(i)) {
            pen = false;
            continue;
          }
          const x = posX(xs[i], scaleX, w, left);
          const y = posY(ys[i], scaleY, h, top);
          if (curve.points || alone) {
            const radius = (curve.points ? 2.2 : 3.5) * ratio;
            markers.moveTo(x + radius, y);
            markers.arc(x, y, radius, 0, 2 * Math.PI);
          } else {
            pen ? line.lineTo(x, y) : line.moveTo(x, y);
            pen = true;
          }
        }
        ctx.stroke(line);
        ctx.fill(markers);
        ctx.restore();
      });
      return null;
    };
  }

  function padded(plot, least, greatest) {
    if (least === null || greatest === null || !isFinite(least)) return [0, 1];
    const margin = (greatest - least || Math.abs(greatest) || 1) * 0.05;
    return [least - margin, greatest + margin];
  }

  phs.painters.xy = (place, spec, figure) => {
    const data = spec.curves.map((curve) => [phs.unpack(curve.x), phs.unpack(curve.y)]);
    const readout = phs.html("div", {class: "readout", "aria-hidden": "true"});
    let plot = null;
    phs.onWidth(place, (width) => {
      if (plot) {
        plot.setSize({width, height: spec.height});
        return;
      }
      plot = new uPlot({
        mode: 2,
        width,
        height: spec.height,
        scales: {x: {time: false, range: padded}, y: {range: padded}},
        axes: [phs.plotAxis(spec.x_label, false), phs.plotAxis(spec.y_label, true)],
        series: [{}, ...spec.curves.map((curve) => ({
          label: curve.label,
          stroke: () => phs.colour(curve.colour),
          facets: [{scale: "x", auto: true}, {scale: "y", auto: true}],
          paths: painter(curve),
        }))],
        legend: {live: false,
          markers: {fill: (u, i) => i > 0 ? `var(--c${spec.curves[i - 1].colour})` : "transparent"}},
        cursor: {drag: {x: true, y: true, uni: 20}, points: {show: false}, dataIdx: () => null},
        hooks: {setCursor: [(u) => {
          const {left, top} = u.cursor;
          readout.textContent = left < 0 ? ""
            : `${spec.x_label}: ${phs.number(u.posToVal(left, "x"))}, ` +
              `${spec.y_label}: ${phs.number(u.posToVal(top, "y"))}`;
        }]},
      }, [null, ...data], place);
      place.append(readout);
      figure.plot = plot;
      const wrap = place.querySelector(".u-wrap");
      wrap.setAttribute("role", "img");
      wrap.setAttribute("aria-label", `${spec.y_label} against ${spec.x_label}: ` +
        spec.curves.map((curve) => curve.label).join(", "));
    });
    phs.recolour.push(() => plot?.redraw(false, false));
  };
})();
