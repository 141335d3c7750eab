// A bogie of the film as shapes: what a body carries moves with it, all else stands where the film
// says. Lengths in metres, axes of L (report/replay.h).
import {
  BoxGeometry, BufferAttribute, BufferGeometry, Color, ConeGeometry, CylinderGeometry, Group,
  Matrix4, Mesh, MeshPhongMaterial, Quaternion, SphereGeometry, SRGBColorSpace, Vector3,
} from "three";

const unitZ = new Vector3(0, 0, 1);
const constant = (colour) => colour.every((c) => typeof c === "number");
const setColour = (colour, [r, g, b]) => colour.setRGB(r, g, b, SRGBColorSpace);
const kinds = {bar: ["cylinder", "capsule", "arrow", "coil"]};
export const isBar = (part) => kinds.bar.includes(part.kind);

export function meshGeometry({vertices: [x, y, z], normals, faces}, mirrored = false) {
  const side = mirrored ? -1 : 1;
  const places = new Float32Array(3 * x.length);
  const directions = new Float32Array(3 * x.length);
  for (let i = 0; i < x.length; ++i) {
    places.set([x[i], side * y[i], z[i]], 3 * i);
    directions.set([normals[3 * i] / 127, side * normals[3 * i + 1] / 127, normals[3 * i + 2] / 127], 3 * i);
  }
  const corners = Uint16Array.from(faces);
  if (mirrored) {
    for (let i = 0; i < corners.length; i += 3) {
      [corners[i + 1], corners[i + 2]] = [corners[i + 2], corners[i + 1]];
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(places, 3));
  geometry.setAttribute("normal", new BufferAttribute(directions, 3));
  geometry.setIndex(new BufferAttribute(corners, 1));
  return geometry;
}

/** Several geometries, each moved by its matrix and in its colour, as one. */
function merge(pieces) {
  const count = pieces.reduce((n, {geometry}) => n + geometry.attributes.position.count, 0);
  const places = new Float32Array(3 * count);
  const directions = new Float32Array(3 * count);
  const colours = new Float32Array(3 * count);
  const corners = [];
  let first = 0;
  const colour = new Color();
  for (const {geometry, matrix, rgb} of pieces) {
    const own = geometry.clone().applyMatrix4(matrix);
    const {position, normal} = own.attributes;
    places.set(position.array, 3 * first);
    directions.set(normal.array, 3 * first);
    setColour(colour, rgb);
    for (let i = 0; i < position.count; ++i) colour.toArray(colours, 3 * (first + i));
    for (const i of own.index.array) corners.push(first + i);
    first += position.count;
    own.dispose();
  }
  const whole = new BufferGeometry();
  whole.setAttribute("position", new BufferAttribute(places, 3));
  whole.setAttribute("normal", new BufferAttribute(directions, 3));
  whole.setAttribute("color", new BufferAttribute(colours, 3));
  whole.setIndex(new BufferAttribute(new Uint32Array(corners), 1));
  return whole;
}

/** Shapes of unit size; bars run from z = 0 to z = 1. */
export function makeShapes(film) {
  const round = new CylinderGeometry(1, 1, 1, 20).rotateX(Math.PI / 2).translate(0, 0, 0.5);
  const meshes = {};
  const mesh = (number, mirrored) =>
    meshes[number + (mirrored ? "m" : "")] ??= meshGeometry(film.meshes[number], mirrored);
  return {
    box: new BoxGeometry(2, 2, 2),
    ball: new SphereGeometry(1, 20, 14),
    cylinder: round,
    capsule: round,
    head: new ConeGeometry(1, 1, 20).rotateX(Math.PI / 2).translate(0, 0, -0.5),
    mesh,
    of(part) {
      if (part.mesh !== undefined) return mesh(part.mesh, part.mirrored);
      return this[part.kind];
    },
  };
}

/** Where a bar from a to b stands; false if it has no length. */
function setBar(object, a, b, radius, unit) {
  const along = b.clone().sub(a);
  const length = along.length();
  if (!(length > 1e-6)) return false;
  object.position.copy(a);
  object.quaternion.setFromUnitVectors(unitZ, along.divideScalar(length));
  object.scale.set(unit ? 1 : radius, unit ? 1 : radius, length);
  return true;
}

function setPlace(object, part, values) {
  if (isBar(part)) {
    const [ax, ay, az, bx, by, bz] = values;
    return setBar(object, new Vector3(ax, ay, az), new Vector3(bx, by, bz), part.size[0],
      part.kind === "coil");
  }
  const [x, y, z, w, i, j, k] = values;
  object.position.set(x, y, z);
  object.quaternion.set(i, j, k, w).normalize();
  if (part.mesh === undefined) object.scale.set(...part.size);
  return true;
}

/** Matrix of a part that a body carries. */
function matrixOf(part) {
  const object = new Group();
  setPlace(object, part, part.place[0]);
  object.updateMatrix();
  return object.matrix;
}

/** A carried part as pieces to be merged; a bar with round ends brings them along. */
function piecesOf(part, shapes, rgb) {
  const pieces = [{geometry: shapes.of(part), matrix: matrixOf(part), rgb}];
  if (part.kind === "capsule") {
    for (const end of [0, 3]) {
      const r = part.size[0];
      pieces.push({geometry: shapes.ball, rgb,
        matrix: new Matrix4().makeScale(r, r, r).setPosition(...part.place[0].slice(end, end + 3))});
    }
  }
  return pieces;
}

export class Vehicle {
  constructor(film, bogie, shapes, read) {
    this.film = film;
    this.bogie = bogie;
    this.read = read;  // value of a course at a moment
    this.root = new Group();
    this.materials = [];
    this.coloured = [];  // [material, course]
    this.moving = [];    // {part, object, head}
    this.bodies = bogie.bodies[0].map(() => {
      const group = new Group();
      this.root.add(group);
      return group;
    });
    this.#addCarried(shapes);
    this.#addMoving(shapes);
  }

  #material(options) {
    const material = new MeshPhongMaterial({shininess: 28, specular: 0x1c1c1c, ...options});
    this.materials.push(material);
    material.userData.opacity = options.opacity ?? 1;
    return material;
  }

  #colourMaterial(number, alpha) {
    const course = this.film.colours[number];
    const material = this.#material({opacity: alpha ?? 1, transparent: (alpha ?? 1) < 1});
    if (constant(course)) setColour(material.color, course);
    else this.coloured.push([material, course]);
    return material;
  }

  #addCarried(shapes) {
    const plain = this.bodies.map(() => []);
    const coloured = new Map();  // "body colour alpha" → pieces
    for (const part of this.bogie.parts) {
      if (part.body === undefined) continue;
      const colour = this.film.colours[part.colour];
      if (constant(colour) && part.alpha === undefined) {
        plain[part.body].push(...piecesOf(part, shapes, colour));
        continue;
      }
      const key = [part.body, part.colour, part.alpha ?? 1].join(" ");
      if (!coloured.has(key)) coloured.set(key, {part, pieces: []});
      coloured.get(key).pieces.push(...piecesOf(part, shapes, [1, 1, 1]));
    }
    const common = this.#material({vertexColors: true});
    plain.forEach((pieces, body) => {
      if (pieces.length > 0) this.bodies[body].add(new Mesh(merge(pieces), common));
    });
    for (const {part, pieces} of coloured.values()) {
      this.bodies[part.body].add(new Mesh(merge(pieces), this.#colourMaterial(part.colour, part.alpha)));
    }
  }

  #addMoving(shapes) {
    const materials = {};
    for (const part of this.bogie.parts) {
      if (part.body !== undefined) continue;
      const material = materials[part.colour + " " + part.alpha] ??=
        this.#colourMaterial(part.colour, part.alpha);
      const arrow = part.kind === "arrow";
      if (arrow) material.emissive.copy(material.color).multiplyScalar(0.35);
      const object = new Mesh(arrow ? shapes.cylinder : shapes.of(part), material);
      const head = arrow ? new Mesh(shapes.head, material) : null;
      this.root.add(object);
      if (head) this.root.add(head);
      this.moving.push({part, object, head});
    }
  }

  /** Ghosts are looked through and carry no arrows. */
  setGhost(ghost) {
    for (const material of this.materials) {
      material.opacity = material.userData.opacity * (ghost ? 0.45 : 1);
      // Of one warm colour, and nearer by a trifle, so that neither flickers through the other.
      material.userData.glow ??= material.emissive.clone();
      if (ghost) material.emissive.setRGB(0.35, 0.08, 0.02);
      else material.emissive.copy(material.userData.glow);
      material.polygonOffset = ghost;
      material.polygonOffsetFactor = material.polygonOffsetUnits = -2;
      material.transparent = material.opacity < 1;
      material.depthWrite = !ghost;
      material.needsUpdate = true;
    }
  }

  update(moment, look, forces) {
    const {read} = this;
    this.bogie.bodies[look].forEach((courses, i) => {
      const [x, y, z, w, qi, qj, qk] = courses.map((course) => read(course, moment));
      this.bodies[i].position.set(x, y, z);
      this.bodies[i].quaternion.copy(new Quaternion(qi, qj, qk, w).normalize());
    });
    for (const [material, course] of this.coloured) {
      setColour(material.color, course.map((c) => read(c, moment)));
    }
    for (const {part, object, head} of this.moving) {
      const values = part.place[look].map((course) => read(course, moment));
      const shown = values.every((v) => !Number.isNaN(v)) && (forces || !head) &&
        setPlace(object, part, values);
      object.visible = shown;
      if (!head) continue;
      head.visible = shown;
      if (!shown) continue;
      // The engine's arrows: the shaft is thinner than the width, the head has a fixed length.
      const width = part.size[0];
      const tip = Math.min(4 * width, 0.6 * object.scale.z);
      head.position.set(values[3], values[4], values[5]);
      head.quaternion.copy(object.quaternion);
      head.scale.set(1.6 * width, 1.6 * width, tip);
      object.scale.set(0.7 * width, 0.7 * width, object.scale.z - 0.9 * tip);
    }
  }
}
