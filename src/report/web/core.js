// What all painters share: reading the packed data, colours of the present theme, elements, numbers.
"use strict";
const phs = (() => {
  /** Painters of figures by kind: (place, spec, figure) => void. */
  const painters = {};

  /** Array of numbers (null = none) from 16-bit steps; see decimation.h. */
  function unpack({least, greatest, packed}) {
    const bytes = atob(packed);
    const height = (greatest - least) / 65534;
    const values = new Array(bytes.length / 2);
    for (let i = 0; i < values.length; ++i) {
      const step = bytes.charCodeAt(2 * i) | bytes.charCodeAt(2 * i + 1) << 8;
      values[i] = step === 65535 ? null : least + step * height;
    }
    return values;
  }

  const style = getComputedStyle(document.documentElement);
  const theme = (name) => style.getPropertyValue("--" + name).trim();
  const colour = (number) => theme("c" + number);
  const dashes = [[], [8, 4], [2, 3], [10, 3, 2, 3]];

  /** "4.100e+8" → "4.1·10⁸". */
  function withPower(text) {
    const [size, power] = text.split("e");
    const raised = String(Number(power)).replace(/./g, (c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]));
    return `${Number(size)}·10${raised}`;
  }
  /** A number with enough digits to read off a plot, with a true minus sign. */
  function number(value, digits = 4) {
    if (value === null || value === undefined || !isFinite(value)) return "–";
    if (value === 0) return "0";
    const size = Math.abs(value);
    const text = size >= 1e6 || size < 1e-4 ? withPower(size.toExponential(digits - 2))
      : size >= 10 ** (digits - 1) ? size.toFixed(0)
      : String(Number(size.toPrecision(digits)));
    return (value < 0 ? "−" : "") + text;
  }

  function fill(element, attributes, children) {
    for (const [name, value] of Object.entries(attributes)) {
      if (value !== null && value !== undefined) element.setAttribute(name, value);
    }
    element.append(...children.filter((child) => child !== null));
    return element;
  }
  const html = (tag, attributes = {}, ...children) =>
    fill(document.createElement(tag), attributes, children);
  const svg = (tag, attributes = {}, ...children) =>
    fill(document.createElementNS("http://www.w3.org/2000/svg", tag), attributes, children);

  /** Round steps that divide [least, greatest] into about `count` parts. */
  function ticks(least, greatest, count) {
    const rough = (greatest - least) / Math.max(1, count);
    if (!(rough > 0)) return [least];
    const power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 2.5, 5, 10].map((k) => k * power).find((k) => k >= rough * 0.999);
    const marks = [];
    for (let i = Math.ceil(least / step - 1e-9); i * step <= greatest + step * 1e-9; ++i) {
      marks.push(Number((i * step).toPrecision(12)));
    }
    return marks;
  }

  /** Calls `draw(width)` now and whenever the width of `place` changes. */
  function onWidth(place, draw) {
    let last = 0;
    const look = () => {
      const width = Math.floor(place.clientWidth);
      if (width > 0 && width !== last) draw(last = width);
    };
    new ResizeObserver(look).observe(place);
    look();
  }

  /** Functions called when the colours change (theme, print). */
  const recolour = [];
  const changed = () => recolour.forEach((redraw) => redraw());
  for (const query of ["(prefers-color-scheme: dark)", "print"]) {
    matchMedia(query).addEventListener("change", changed);
  }

  /** Functions called once everything else of the page is drawn. */
  const afterwards = [];

  return {afterwards, painters, unpack, theme, colour, dashes, number, html, svg, ticks, onWidth, recolour};
})();
