// The replay: controls, place and captions. What is drawn in three dimensions is the scene's
// (scene/scene.js), which starts once everything else of the page is drawn and the replay is near
// the window.
"use strict";
(() => {
  const speeds = [0.1, 0.25, 0.5, 1, 2, 5];
  const kLongest = 250;  // shown of one picture to the next [ms]
  const noPicture = "The picture in three dimensions needs WebGL 2, which this browser does not offer here. " +
    "Tables, plots and drawings are complete without it.";

  const option = (value, text) => phs.html("option", {value}, text);
  function select(name, entries, chosen, change) {
    const element = phs.html("select", {"aria-label": name}, ...entries.map(([v, text]) => option(v, text)));
    element.value = String(chosen);
    element.addEventListener("change", () => change(element.value));
    return phs.html("label", {}, name + " ", element);
  }
  function tick(name, chosen, change) {
    const element = phs.html("input", {type: "checkbox"});
    element.checked = chosen;
    element.addEventListener("change", () => change(element.checked));
    return phs.html("label", {}, element, " " + name);
  }

  /** A strip of the colours that pressures have. */
  function pressureScale({low, high, colours}) {
    if (!(high > low)) return null;
    const stops = colours.map((rgb, i) =>
      `rgb(${rgb.map((c) => Math.round(255 * c)).join(" ")}) ${100 * i / (colours.length - 1)}%`);
    return phs.html("div", {class: "pressures"}, `Line pressure ${phs.number(low / 1e6)} `,
      phs.html("i", {style: `background: linear-gradient(to right, ${stops.join(", ")})`}),
      ` ${phs.number(high / 1e6)} MPa absolute`);
  }

  class Replay {
    constructor(place, figure) {
      this.film = phs.film.get();
      this.figure = figure;
      const {film} = this;
      this.at = film.start;
      this.view = {...film.views[0], target: [...film.views[0].target]};
      this.look = 0;
      this.forces = true;
      this.speed = 1;
      this.ghost = false;
      this.chosen = film.bogies.length > 1 ? [0, 1] : [0];
      this.canvas = phs.html("canvas", {tabindex: 0, role: "img",
        "aria-label": "The bogies on the track in three dimensions; drag to turn, arrow keys to turn, plus and minus to near"});
      this.captions = phs.html("div", {class: "captions"});
      this.picture = phs.html("div", {class: "picture"}, this.canvas, this.captions);
      place.append(this.#bar(), this.picture, this.#options());
      const scale = pressureScale(film.pressures);
      if (scale) place.append(scale);
      this.who = phs.html("p", {class: "who"});
      place.append(this.who);
      place.append(phs.html("p", {class: "readout"}, film.arrows));
      this.cursor = phs.cursor.join((x) => {
        this.#stop();
        this.#show(x);
      });
      this.#write();
      phs.onWidth(place, (width) => this.#resize(width));
      phs.recolour.push(() => this.#draw());
    }

    #bar() {
      this.button = phs.html("button", {type: "button", class: "play"}, "▶ Play");
      this.button.addEventListener("click", () => this.running ? this.#stop() : this.#run());
      this.slider = phs.html("input", {type: "range", min: this.film.begin, max: this.film.end,
        step: (this.film.end - this.film.begin) / 2000, "aria-label": "place along the track"});
      this.slider.addEventListener("input", () => {
        this.#stop();
        this.#move(Number(this.slider.value));
      });
      this.output = phs.html("output");
      return phs.html("div", {class: "bar"}, this.button, this.slider, this.output);
    }

    #options() {
      const {film} = this;
      const parts = [
        select("Speed", speeds.map((v) => [v, v + " ×"]), 1, (v) => { this.speed = Number(v); }),
        select("Seen", film.views.map(({name, text}, i) => [i, text]), 0, (v) => {
          this.view = {...film.views[v], target: [...film.views[v].target]};
          this.#draw();
        }),
        select("Drawn", film.looks.map((name, i) => [i, name]), 0, (v) => {
          this.look = Number(v);
          this.#draw();
        }),
        tick("forces", true, (on) => { this.forces = on; this.#draw(); }),
      ];
      if (film.bogies.length > 1) {
        const names = film.bogies.map((bogie, i) => [i, bogie.title]);
        parts.push(tick("one as a ghost in the other", false, (on) => {
          this.ghost = on;
          this.#resize(this.width);
        }));
        if (film.bogies.length > 2) {
          this.chosen.forEach((number, i) => parts.push(select(i ? "and" : "Bogies", names, number, (v) => {
            this.chosen[i] = Number(v);
            this.#write();
            this.#draw();
          })));
        }
      }
      return phs.html("div", {class: "options"}, ...parts);
    }

    panes() {
      if (this.chosen.length < 2 || this.chosen[0] === this.chosen[1]) return [[this.chosen[0]]];
      return this.ghost ? [this.chosen] : this.chosen.map((number) => [number]);
    }

    #resize(width) {
      const panes = this.panes().length;
      this.width = width;
      this.stacked = panes > 1 && width < 700;
      const one = this.stacked || panes === 1 ? width : width / panes;
      this.height = Math.round(Math.min(520, Math.max(230, one * 0.62)) * (this.stacked ? panes : 1));
      this.picture.style.height = this.height + "px";
      if (this.scene) this.scene.resize(width, this.height, Math.min(2, devicePixelRatio));
      this.#write();
      this.#draw();
    }

    /** Texts over the picture and beside the slider. */
    #write() {
      const {film, at} = this;
      this.slider.value = at;
      this.output.textContent = `${phs.number(at, 4)} m, ${phs.film.timeAt(at).toFixed(2)} s`;
      const panes = this.panes();
      this.captions.className = "captions" + (this.stacked ? " stacked" : "");
      this.captions.replaceChildren(...panes.map((pane) => phs.html("div", {}, ...pane.map((number, i) => {
        const bogie = film.bogies[number];
        const ended = at > bogie.last_s + 1 ? [["run", `ended at ${phs.number(bogie.last_s)} m`]] : [];
        // Where panes are small, the one thing that tells bogies apart.
        const few = this.stacked ? ["angle of attack"] : ["speed", "curve", "angle of attack", "sum of Y"];
        const lines = [...ended, ...phs.film.captions(bogie, at).filter(([name]) => few.includes(name))];
        return phs.html("div", {style: `border-color: var(--c${bogie.colour ?? 0})`},
          phs.html("strong", {}, bogie.title + (i ? " (ghost)" : "")),
          ...lines.map(([name, text]) => phs.html("span", {}, phs.html("b", {}, name + " "), text)));
      }))));
      this.figure.dataset.place = at;
      this.#tellWho();
    }

    /** Which bogie is which in the picture, and what its colours mean. */
    #tellWho() {
      const {film, chosen} = this;
      const now = [this.ghost, this.stacked, ...chosen].join();
      if (now === this.told) return;
      this.told = now;
      const [first, second] = chosen.map((number) => film.bogies[number]);
      const key = (style, words) => phs.html("span", {}, phs.html("i", {style}), words);
      const plot = (bogie) => `background: var(--c${bogie.colour ?? 0})`;
      const pair = this.panes().length > 1;
      if (this.ghost && second && first !== second) {
        this.who.replaceChildren(
          key("background: var(--steel-high)", `${first.title}: solid, in the colours of its parts, with arrows.`),
          key("background: rgb(200 105 70 / .55)",
            `${second.title}: the ghost, reddish and looked through, without arrows.`));
      } else {
        this.who.replaceChildren(...(pair ? [first, second] : [first]).map((bogie, i) => key(plot(bogie),
          !pair ? bogie.title : `${bogie.title}: ${this.stacked ? ["above", "below"][i] : ["left", "right"][i]}.`)),
        phs.html("span", {}, "The stripe beside a name has the colour of its curves in the " +
          "plots. Parts have their own colours, lines and cylinders that of their pressure."));
      }
    }

    #show(place) {
      this.at = Math.max(this.film.begin, Math.min(this.film.end, place));
      this.#write();
      this.#draw();
    }
    #move(place) {
      this.#show(place);
      this.cursor.move(this.at);
    }

    #draw() {
      if (!this.scene || this.asked) return;
      this.asked = true;
      requestAnimationFrame(() => {
        this.asked = false;
        this.#drawNow();
      });
    }
    #drawNow() {
      this.scene.draw({place: this.at, look: this.look, forces: this.forces, view: this.view,
        panes: this.panes(), stacked: this.stacked, width: this.width, height: this.height,
        ground: phs.theme("card")});
      this.figure.dataset.frames = Number(this.figure.dataset.frames ?? 0) + 1;
    }

    #run() {
      this.running = true;
      this.button.textContent = "❚❚ Pause";
      if (this.at > this.film.end - 1e-3) this.#move(this.film.begin);
      let before = performance.now();
      const step = (now) => {
        if (!this.running) return;
        // A machine that draws slowly shows the run slower, not in jumps.
        const passed = Math.min(Math.max(0, now - before), kLongest);
        const time = phs.film.timeAt(this.at) + passed / 1000 * this.speed;
        before = now;
        this.#move(phs.film.placeAt(time));
        if (this.at > this.film.end - 1e-3) this.#stop();
        else requestAnimationFrame(step);
      };
      requestAnimationFrame(step);
    }
    #stop() {
      if (!this.running) return;
      this.running = false;
      this.button.textContent = "▶ Play";
    }

    #turn(across, up) {
      this.view.azimuth -= across;
      this.view.elevation = Math.max(-89.9, Math.min(15, this.view.elevation - up));
      this.#draw();
    }
    #near(factor) {
      this.view.distance = Math.max(0.8, Math.min(40, this.view.distance * factor));
      this.#draw();
    }

    #listen() {
      const {canvas} = this;
      let last = null;
      canvas.addEventListener("pointerdown", (event) => {
        last = event;
        canvas.setPointerCapture(event.pointerId);
        canvas.focus({preventScroll: true});
      });
      canvas.addEventListener("pointermove", (event) => {
        if (!last || last.pointerId !== event.pointerId) return;
        this.#turn(0.4 * (event.clientX - last.clientX), 0.3 * (event.clientY - last.clientY));
        last = event;
      });
      for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => { last = null; });
      // The page scrolls over the picture until it has been clicked.
      canvas.addEventListener("wheel", (event) => {
        if (document.activeElement !== canvas) return;
        event.preventDefault();
        this.#near(Math.exp(0.001 * event.deltaY));
      }, {passive: false});
      const keys = {ArrowLeft: [5, 0], ArrowRight: [-5, 0], ArrowUp: [0, 4], ArrowDown: [0, -4]};
      canvas.addEventListener("keydown", (event) => {
        if (keys[event.key]) this.#turn(...keys[event.key]);
        else if (event.key === "+") this.#near(0.85);
        else if (event.key === "-") this.#near(1 / 0.85);
        else return;
        event.preventDefault();
      });
      const nearer = [["+", 0.8, "nearer"], ["−", 1.25, "farther"]].map(([sign, factor, words]) => {
        const button = phs.html("button", {type: "button", "aria-label": words}, sign);
        button.addEventListener("click", () => this.#near(factor));
        return button;
      });
      this.picture.append(phs.html("div", {class: "near"}, ...nearer));
    }

    /** Runs the script of the scene; without WebGL a sentence stands in its place. */
    start() {
      const context = this.canvas.getContext("webgl2", {antialias: true, preserveDrawingBuffer: true});
      if (!context) {
        this.picture.replaceWith(phs.html("p", {class: "note"}, noPicture));
        this.figure.dataset.scene = "none";
        performance.mark("phs-scene");
        return;
      }
      document.head.append(phs.html("script", {}, document.getElementById("scene").textContent));
      const {value, moment} = phs.film;
      this.scene = phsScene.create(this.canvas, context, this.film, value, moment);
      this.#listen();
      this.#resize(this.width);
      this.figure.scene = this.scene;
      this.figure.dataset.scene = "yes";
      performance.mark("phs-scene");
    }
  }

  phs.painters.replay = (place, spec, figure) => {
    place.append(phs.html("p", {class: "readout"}, "The replay is being prepared …"));
    phs.afterwards.push(() => {
      place.replaceChildren();
      const replay = new Replay(place, figure);
      const seen = new IntersectionObserver((entries) => {
        if (!entries.some((entry) => entry.isIntersecting)) return;
        seen.disconnect();
        replay.start();
      }, {rootMargin: "400px"});
      seen.observe(figure);
    });
  };
})();
