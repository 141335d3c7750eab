// The film of a run (report/replay.h): read once the page is drawn, places at any arc length between
// its instants.
"use strict";
phs.film = (() => {
  let film = null;

  const bytesOf = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  /** A course is a number, or packed numbers of all instants. */
  const course = (value) => typeof value === "number" || value === null ? value
    : Float32Array.from(phs.unpack(value), (x) => x ?? NaN);

  function read(all) {
    all.time = phs.unpack(all.time);
    all.colours = all.colours.map((colour) => colour.map(course));
    all.track.stations = new Float32Array(bytesOf(all.track.stations).buffer);
    for (const mesh of all.meshes) {
      mesh.vertices = mesh.vertices.map((axis) => phs.unpack(axis));
      mesh.normals = new Int8Array(bytesOf(mesh.normals).buffer);
      mesh.faces = new Uint16Array(bytesOf(mesh.faces).buffer);
    }
    for (const bogie of all.bogies) {
      bogie.middle = phs.unpack(bogie.middle);
      bogie.bodies = bogie.bodies.map((look) => look.map((body) => body.map(course)));
      for (const part of bogie.parts) part.place = part.place.map((look) => look.map(course));
      for (const wheel of bogie.wheels) {
        for (const key of ["y", "z", "roll"]) wheel[key] = course(wheel[key]);
        wheel.patches = wheel.patches.map((patch) => patch.map(course));
      }
    }
    return all;
  }

  /** The film of this page, null without one. */
  function get() {
    if (film) return film;
    const element = document.getElementById("film");
    if (!element) return null;
    film = read(JSON.parse(element.textContent));
    return film;
  }

  /** Row before arc length s and share of the way to the next. */
  function moment(s) {
    const {begin, end, points} = film;
    const place = Math.max(0, Math.min(points - 1, (s - begin) / (end - begin) * (points - 1)));
    const row = Math.min(points - 2, Math.floor(place));
    return {row, share: place - row, nearest: Math.round(place)};
  }
  function value(values, {row, share}) {
    if (typeof values === "number") return values;
    return values[row] + share * (values[row + 1] - values[row]);
  }
  /** Arc length at a time, and back. */
  function placeAt(time) {
    const {time: t, begin, end, points} = film;
    let row = 0;
    let last = points - 1;
    while (last - row > 1) {
      const middle = (row + last) >> 1;
      if (t[middle] <= time) row = middle; else last = middle;
    }
    const share = t[row + 1] > t[row] ? Math.max(0, Math.min(1, (time - t[row]) / (t[row + 1] - t[row]))) : 0;
    return begin + (row + share) / (points - 1) * (end - begin);
  }
  const timeAt = (s) => value(film.time, moment(s));
  const captions = (bogie, s) => bogie.captions.map(({name, texts, which}) =>
    [name, texts[which[moment(s).nearest]]]);

  return {get, moment, value, placeAt, timeAt, captions};
})();
