// Rails, sleepers and bed about the vehicle, from the film's stations along the true alignment.
import {BoxGeometry, Color, Group, InstancedMesh, Matrix4, MeshPhongMaterial, SRGBColorSpace, Vector3} from "three";
import {meshGeometry} from "./scene_parts.js";

const kReach = 42;  // [m] before and behind the vehicle
const kNumbers = 13;

export class Track {
  constructor(film) {
    this.film = film.track;
    this.root = new Group();
    const {rail, bed, colours, sleeper} = film.track;
    this.count = Math.ceil(2 * kReach / this.film.step);
    const add = (geometry, [r, g, b], shininess) => {
      const material = new MeshPhongMaterial({shininess, specular: 0x181818});
      material.color.setRGB(r, g, b, SRGBColorSpace);
      const mesh = new InstancedMesh(geometry, material, this.count);
      mesh.frustumCulled = false;
      this.root.add(mesh);
      return mesh;
    };
    this.left = add(meshGeometry(film.meshes[rail]), colours[0], 40);
    this.right = add(meshGeometry(film.meshes[rail], true), colours[0], 40);
    this.sleepers = add(new BoxGeometry(...sleeper.map((half) => 2 * half)), colours[1], 4);
    this.bed = add(meshGeometry(film.meshes[bed]), colours[2], 0);
  }

  station(i) {
    const {stations} = this.film;
    const last = stations.length / kNumbers - 1;
    const at = kNumbers * Math.max(0, Math.min(last, i));
    const vector = (k) => new Vector3(stations[at + k], stations[at + k + 1], stations[at + k + 2]);
    return {origin: vector(0), left: vector(3), up: vector(6),
      rails: [[stations[at + 9], stations[at + 10]], [stations[at + 11], stations[at + 12]]]};
  }

  /** World to L at arc length s. */
  toVehicle(s) {
    const place = (s - this.film.begin) / this.film.step;
    const i = Math.floor(place);
    const a = this.station(i);
    const b = this.station(i + 1);
    const origin = a.origin.lerp(b.origin, place - i);
    const left = a.left.lerp(b.left, place - i);
    const side = new Vector3(left.x, left.y, 0).normalize();
    const forward = new Vector3(side.y, -side.x, 0);
    return new Matrix4().makeBasis(forward, side, new Vector3(0, 0, 1)).setPosition(origin).invert();
  }

  /** Fills everything anew about arc length s. */
  update(s) {
    const toL = this.toVehicle(s);
    const first = Math.round((s - kReach - this.film.begin) / this.film.step);
    const matrix = new Matrix4();
    const put = (mesh, k, along, left, up, origin) =>
      mesh.setMatrixAt(k, matrix.makeBasis(along, left, up).setPosition(origin).premultiply(toL));
    const railAt = ({origin, left, up, rails}, i) =>
      origin.clone().addScaledVector(left, rails[i][0]).addScaledVector(up, rails[i][1]);
    let here = this.station(first);
    for (let k = 0; k < this.count; ++k) {
      const next = this.station(first + k + 1);
      [this.left, this.right].forEach((mesh, i) => {
        const from = railAt(here, i);
        put(mesh, k, railAt(next, i).sub(from), here.left, here.up, from);
      });
      put(this.bed, k, next.origin.clone().sub(here.origin), here.left, here.up, here.origin);
      put(this.sleepers, k, here.left.clone().cross(here.up), here.left, here.up,
        here.origin.clone().addScaledVector(here.up, this.film.sleeper_height));
      here = next;
    }
    for (const mesh of [this.left, this.right, this.sleepers, this.bed]) mesh.instanceMatrix.needsUpdate = true;
  }
}
