// The film of a run in three dimensions: bundled with what it needs of three.js into one text, which
// the page runs once everything else is drawn. It knows nothing of the page but a canvas.
import {Color, DirectionalLight, Fog, HemisphereLight, PerspectiveCamera, Scene, Vector3, WebGLRenderer} from "three";
import {makeShapes, Vehicle} from "./scene_parts.js";
import {Track} from "./scene_track.js";

const kFieldOfView = 35;  // of view/camera.h's distances [deg]

function setCamera(camera, view, aspect) {
  const radians = Math.PI / 180;
  const elevation = view.elevation * radians;
  const azimuth = view.azimuth * radians;
  const sight = new Vector3(Math.cos(elevation) * Math.cos(azimuth),
    Math.cos(elevation) * Math.sin(azimuth), Math.sin(elevation));
  const target = new Vector3(...view.target);
  // The views are made for pictures wider than high.
  const distance = view.distance * Math.max(1, 1.45 / aspect);
  camera.aspect = aspect;
  camera.position.copy(target).addScaledVector(sight, -distance);
  camera.up.set(0, 0, 1);
  camera.lookAt(target);
  camera.updateProjectionMatrix();
}

/**
 * `film` and `moment` as film.js has them, `context` a WebGL 2 context of `canvas`.
 * draw({place, look, forces, view, panes: [[bogie, ghost?]…], stacked, ground}).
 */
function create(canvas, context, film, read, moment) {
  const renderer = new WebGLRenderer({canvas, context, antialias: true, preserveDrawingBuffer: true});
  const scene = new Scene();
  const camera = new PerspectiveCamera(kFieldOfView, 1, 0.05, 120);
  const sun = new DirectionalLight(0xfff6e8, 2.1);
  scene.add(new HemisphereLight(0xf4f8ff, 0xa8a297, 2.5), sun, sun.target);
  scene.fog = new Fog(0xffffff, 15, 44);
  const track = new Track(film);
  scene.add(track.root);
  const shapes = makeShapes(film);
  const vehicles = film.bogies.map((bogie) => {
    const vehicle = new Vehicle(film, bogie, shapes, read);
    scene.add(vehicle.root);
    return vehicle;
  });

  function drawPane([number, ghost], state, box) {
    const at = moment(state.place);
    const middle = read(film.bogies[number].middle, at);
    track.update(middle);
    vehicles.forEach((vehicle, i) => {
      vehicle.root.visible = i === number || i === ghost;
      if (!vehicle.root.visible) return;
      vehicle.update(at, state.look, state.forces && i === number);
      vehicle.root.position.x = read(film.bogies[i].middle, at) - middle;
      if (vehicle.ghost !== (i === ghost)) vehicle.setGhost(vehicle.ghost = i === ghost);
    });
    setCamera(camera, state.view, box.width / box.height);
    sun.position.copy(camera.position).add(new Vector3(2, 3, 6));
    renderer.setViewport(box.left, box.bottom, box.width, box.height);
    renderer.setScissor(box.left, box.bottom, box.width, box.height);
    renderer.render(scene, camera);
  }

  return {
    resize(width, height, ratio) {
      renderer.setPixelRatio(ratio);
      renderer.setSize(width, height, false);
    },
    draw(state) {
      const {panes, width, height} = state;
      const ground = new Color(state.ground);
      scene.fog.color.copy(ground);
      renderer.setClearColor(ground, 1);
      renderer.setScissorTest(false);
      renderer.clear();
      renderer.setScissorTest(true);
      panes.forEach((pane, i) => drawPane(pane, state, state.stacked
        ? {left: 0, width, height: height / panes.length, bottom: height * (1 - (i + 1) / panes.length)}
        : {left: i * width / panes.length, width: width / panes.length, height, bottom: 0}));
    },
    /** For tests: where the vehicle's first body stands in L, and what was drawn. */
    look: (number) => ({body: vehicles[number].bodies[0].position.toArray(),
      triangles: renderer.info.render.triangles}),
  };
}

globalThis.phsScene = {create};
