// The view from outside, into rooms whose near walls and ceilings are left out.

import {Box3, MathUtils, PerspectiveCamera, Vector3} from 'three';

import {newControls} from './controls.js';
import {fittingPosition, freeArea} from './fitting.js';

const vertical_angle = 36; // degrees
const tangent = Math.tan(MathUtils.degToRad(vertical_angle / 2));

// Down at an angle, to an azimuth, radians.
function directionOf(azimuth, down) {
  return new Vector3(-Math.sin(azimuth) * Math.cos(down), -Math.sin(down), -Math.cos(azimuth) * Math.cos(down));
}

export class Dollhouse {
  constructor(world, canvas) {
    this.name = 'dollhouse';
    this.hint = 'drag: turn · right button: move · wheel: nearer · click: what it is';
    this.world = world;
    this.camera = new PerspectiveCamera(vertical_angle, 1, 0.1, 1000);
    this.controls = newControls(this.camera, canvas);
    this.controls.maxPolarAngle = MathUtils.degToRad(100);
    this.controls.dollyToCursor = true;
  }

  resize(width, height) {
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
  }

  // How much of the front of the surfaces a direction shows, for the size that they have then.
  merit(direction, area) {
    const at = this.fit(this.world.places, direction, area);
    const depth = at.sub(this.world.center).length();
    const shown = this.world.items.planes.reduce((sum, item) => this.world.fragments.has(item.id) ? sum :
      sum + item.area * Math.max(0, -item.normal.dot(direction)), 0);
    return shown / depth ** 2;
  }

  fit(places, direction, area) {
    return fittingPosition(places, direction, tangent, this.camera.aspect, area);
  }

  home(moves = false) {
    const area = freeArea();
    const width = (area.right - area.left) * this.camera.aspect, height = area.top - area.bottom;
    const down = MathUtils.degToRad(width > height ? 42 : 54);
    let best = null;
    for (let k = 0; k < 24; ++k) {
      const direction = directionOf(k * Math.PI / 12 + 0.26, down);
      const merit = this.merit(direction, area);
      if (!best || merit > best.merit * 1.001)
        best = {merit, direction};
    }
    this.lookAt(this.world.places, best.direction, area, moves);
  }

  lookAt(places, direction, area, moves) {
    const at = this.fit(places, direction, area);
    const middle = new Box3().setFromPoints(places).getCenter(new Vector3());
    const distance = Math.max(0.5, middle.sub(at).dot(direction));
    const to = at.clone().addScaledVector(direction, distance);
    this.controls.setLookAt(...at, ...to, moves);
  }

  // Looks at its front, with what is around it.
  show(item) {
    const now = this.controls.getTarget(new Vector3()).sub(this.controls.getPosition(new Vector3())).normalize();
    const direction = now.clone();
    if (item.normal && item.normal.dot(now) > -0.25) {
      const level = item.normal.clone().setY(0);
      if (level.length() > 0.3)
        direction.copy(level.normalize().multiplyScalar(-0.85)).setY(-0.55).normalize();
      else
        direction.setY(-Math.sign(item.normal.y) * 0.7).normalize();
    }
    const places = item.loops.flat();
    const middle = new Box3().setFromPoints(places).getCenter(new Vector3());
    const around = places.map(p => middle.clone().lerp(p, 1.3));
    for (const k of [-1, 1]) // not nearer than this to small ones
      around.push(middle.clone().add(new Vector3(k, 0, k)), middle.clone().add(new Vector3(k, 0, -k)));
    this.lookAt(around, direction, freeArea(), true);
  }

  // What is left of a plane: nothing from behind, little where one looks along it.
  opacityOf(item) {
    const offset = this.camera.position.clone().sub(item.place);
    return MathUtils.smoothstep(item.normal.dot(offset) / offset.length(), 0.01, 0.09);
  }

  setClipping() {
    const distance = this.camera.position.distanceTo(this.world.center) + this.world.radius;
    this.camera.near = Math.max(0.05, distance - 2.2 * this.world.radius) / 2;
    this.camera.far = 1.5 * distance;
    this.camera.updateProjectionMatrix();
  }
}
