// The numbers behind every plot, bar chart and table: shown as a table and saved as CSV. Made in the
// page from what it carries; nothing is asked from anywhere.
"use strict";
(() => {
  const kShown = 200;  // rows of the table on the page; the file has all of them
  let specs = null;    // read again here: painters may change theirs
  const specOf = (figure) =>
    (specs ??= JSON.parse(document.getElementById("figures").textContent))[figure.id];

  /** Steps of 16 bit: more digits would be made up. */
  const digits = (value) => value === null || value === undefined || !isFinite(value) ? ""
    : String(Number(value.toPrecision(6)));
  const unitOf = (label) => /\[[^\]]*\]\s*$/.exec(label)?.[0] ?? "";
  const named = (curve, label) => [curve, unitOf(label)].filter(Boolean).join(" ");
  const gridOf = (grid) => Array.from({length: grid.points},
    (_, i) => grid.begin + (i + 0.5) * (grid.end - grid.begin) / grid.points);

  /** Columns {head, values} of a figure by its kind; a kind that is not here has no table. */
  const columns = {
    series: (spec) => [{head: spec.x_label, values: spec.x ?? gridOf(spec.grid)},
      ...spec.curves.map((curve) => ({head: named(curve.label, spec.y_label),
        values: phs.unpack(curve.y)}))],
    xy: (spec) => spec.curves.flatMap((curve) => [
      {head: named(`${curve.label}: ${spec.x_label.replace(/\s*\[[^\]]*\]\s*$/, "")}`, spec.x_label),
        values: phs.unpack(curve.x)},
      {head: named(`${curve.label}: ${spec.y_label.replace(/\s*\[[^\]]*\]\s*$/, "")}`, spec.y_label),
        values: phs.unpack(curve.y)}]),
    heat: (spec) => {
      const cells = spec.values.flatMap((row, j) => row.map((value, i) =>
        [spec.x_edges[i], spec.x_edges[i + 1], spec.y_edges[j], spec.y_edges[j + 1], value]));
      return [`${spec.x_label}, from`, `${spec.x_label}, to`, `${spec.y_label}, from`,
        `${spec.y_label}, to`, spec.value_label].map((head, k) =>
        ({head, values: cells.map((cell) => cell[k])}));
    },
    shape: (spec) => {
      const points = spec.lines.flatMap((line) => [line.from, line.to]);
      return [["along the track, at rest [m]", (p) => p.x], ["to the left, at rest [m]", (p) => p.y],
        ["motion along, real part as drawn [m]", (p) => p.dx[0]],
        ["motion along, imaginary part as drawn [m]", (p) => p.dx[1]],
        ["motion to the left, real part as drawn [m]", (p) => p.dy[0]],
        ["motion to the left, imaginary part as drawn [m]", (p) => p.dy[1]]]
        .map(([head, value]) => ({head, values: points.map(value)}));
    },
    plan: (spec) => [{head: "distance [m]", values: gridOf(spec.grid)},
      {head: "curvature of the track [1/m]", values: phs.unpack(spec.curvature)},
      ...spec.bogies.flatMap((bogie) => [["lead", "leading axle"], ["trail", "trailing axle"]]
        .flatMap(([key, axle]) => [
          {head: `${bogie.label}, ${axle}: angle of attack to the left [rad]`,
            values: phs.unpack(bogie[key].attack)},
          {head: `${bogie.label}, ${axle}: yaw in the bogie [rad]`,
            values: phs.unpack(bogie[key].yaw)},
          {head: `${bogie.label}, ${axle}: place to the left [m]`,
            values: phs.unpack(bogie[key].lateral)}]))],
  };
  phs.dataColumns = columns;

  /** Rows of texts of a figure: the head first. */
  function rowsOf(figure) {
    const list = columns[figure.dataset.kind](specOf(figure));
    const length = Math.max(0, ...list.map((column) => column.values.length));
    return [list.map((column) => column.head), ...Array.from({length},
      (_, i) => list.map((column) => digits(column.values[i])))];
  }

  /** A number as this page writes it ("−2.0·10⁻⁴") as a program reads it; other texts as they are. */
  function machineText(text) {
    const raised = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    const plain = text.trim().replace(/·10(⁻?)([⁰¹²³⁴⁵⁶⁷⁸⁹]+)$/, (_, minus, power) =>
      `e${minus ? "-" : ""}${[...power].map((c) => raised.indexOf(c)).join("")}`);
    if (plain === "–") return "";
    return /^−?[\d.]+(e-?\d+)?$/.test(plain) ? plain.replace("−", "-") : text.trim();
  }
  const rowsOfTable = (table) => [...table.rows].map((row) =>
    [...row.cells].map((cell) => machineText(cell.textContent)));
  function rowsOfBars(figure) {
    const rows = [["", "", figure.querySelector("figcaption").textContent]];
    let category = "";
    for (const row of figure.querySelectorAll("tr")) {
      if (row.cells.length === 1) category = row.textContent.trim();
      else rows.push([category, row.cells[0].textContent.trim(),
        machineText(row.cells[row.cells.length - 1].textContent)]);
    }
    return rows;
  }

  const cell = (text) => /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  const csv = (rows) => rows.map((row) => row.map(cell).join(",")).join("\n") + "\n";
  phs.csvOf = csv;

  function save(name, rows) {
    const url = URL.createObjectURL(new Blob([csv(rows)], {type: "text/csv"}));
    const file = name.toLowerCase().replace(/[^a-z0-9]+/g, "_").replace(/^_+|_+$/g, "").slice(0, 80);
    phs.html("a", {href: url, download: `${file || "data"}.csv`}).click();
    setTimeout(() => URL.revokeObjectURL(url), 10000);
  }

  function button(words, label, act) {
    const made = phs.html("button", {type: "button", class: "data-button", "aria-label": label}, words);
    made.addEventListener("click", act);
    return made;
  }

  function panelOf(figure, title) {
    const rows = rowsOf(figure);
    const body = rows.slice(1, 1 + kShown);
    const words = rows.length - 1 > kShown ? `The first ${kShown} of ${rows.length - 1} rows. ` : "";
    const rounded = figure.dataset.kind === "heat" || figure.dataset.kind === "shape" ? ""
      : "As drawn: thinned out where there are many, rounded to 1/65 000 of the range. ";
    return phs.html("div", {class: "data-panel"},
      phs.html("p", {}, words + rounded, button("Save as CSV", `Save ${title} as CSV`,
        () => save(title, rows))),
      phs.html("div", {class: "data-rows", tabindex: "0"}, phs.html("table", {},
        phs.html("thead", {}, phs.html("tr", {},
          ...rows[0].map((text) => phs.html("th", {scope: "col"}, text)))),
        phs.html("tbody", {}, ...body.map((row) =>
          phs.html("tr", {}, ...row.map((text) => phs.html("td", {}, text.replace("-", "−")))))))));
  }

  for (const figure of document.querySelectorAll("figure.plot")) {
    if (!columns[figure.dataset.kind]) continue;
    const caption = figure.querySelector("figcaption");
    const title = caption.textContent;
    let panel = null;
    const toggle = button("Data", `Numbers of ${title}`, () => {
      if (panel) panel.remove();
      panel = panel ? null : panelOf(figure, title);
      if (panel) figure.append(panel);
      toggle.setAttribute("aria-expanded", String(panel !== null));
    });
    toggle.setAttribute("aria-expanded", "false");
    caption.append(toggle);
  }
  for (const figure of document.querySelectorAll("figure.bars")) {
    const caption = figure.querySelector("figcaption");
    const rows = rowsOfBars(figure);
    caption.append(button("CSV", `Save ${rows[0][2]} as CSV`, () => save(rows[0][2], rows)));
  }
  for (const place of document.querySelectorAll(".scroll")) {
    const caption = place.previousElementSibling;
    if (!caption || !caption.classList.contains("caption")) continue;
    const title = caption.textContent;
    caption.append(button("CSV", `Save ${title} as CSV`,
      () => save(title || document.title, rowsOfTable(place.querySelector("table")))));
  }
})();
