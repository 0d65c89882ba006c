// The view from within: from where the camera stood, or from the middle of the largest room.

import {MathUtils, PerspectiveCamera, Raycaster, Vector3} from 'three';

import {actions, newControls} from './controls.js';

const arm = 0.01; // metres from the eye to the point about which it turns
const down = new Vector3(0, -1, 0);

export class Inside {
  constructor(world, canvas) {
    this.name = 'inside';
    this.hint = 'drag: look around · click on the floor: walk there · click: what it is';
    this.world = world;
    this.camera = new PerspectiveCamera(70, 1, 0.03, 1000);
    this.controls = newControls(this.camera, canvas);
    this.controls.minDistance = this.controls.maxDistance = arm;
    this.controls.azimuthRotateSpeed = this.controls.polarRotateSpeed = -0.35;
    this.controls.mouseButtons.right = this.controls.mouseButtons.middle = actions.NONE;
    this.controls.mouseButtons.wheel = actions.ZOOM;
    this.controls.touches.two = actions.TOUCH_ZOOM;
    this.controls.touches.three = actions.NONE;
    this.controls.minZoom = 0.7;
    this.controls.maxZoom = 6;
    this.controls.smoothTime = 0.35;
    this.eye_height = 1.6;
  }

  resize(width, height) {
    this.camera.aspect = width / height;
    // at least 55 degrees from side to side
    const least = 2 * Math.atan(Math.tan(MathUtils.degToRad(27.5)) * height / width);
    this.camera.fov = Math.min(95, Math.max(70, MathUtils.radToDeg(least)));
    this.camera.updateProjectionMatrix();
  }

  // The height of a floor below a place, or null.
  floorBelow(place) {
    const ray = new Raycaster(place, down);
    ray.firstHitOnly = true;
    const floors = this.world.meshesOf(item => item.role === 'floor' && item.normal);
    return ray.intersectObjects(floors, false)[0]?.point.y ?? null;
  }

  // {at, direction} where a visit begins.
  start() {
    const poses = this.world.map.trajectory ?? [];
    const first = poses[0];
    if (first) {
      const at = this.world.frame.place(first.position);
      const floor = this.floorBelow(at);
      if (floor !== null && at.y - floor > 0.4 && at.y - floor < 2.2)
        this.eye_height = at.y - floor;
      const direction = new Vector3(0, 0, 1).applyQuaternion(this.world.frame.orientation(first.orientation));
      return {at, direction: poses.length > 1 ? direction : this.farthest(at)};
    }
    const room = this.world.items.rooms[0];
    const at = room ? room.place.clone() : this.world.center.clone();
    const floor = this.floorBelow(at.clone().setY(at.y + 0.5));
    at.y = (floor ?? (room ? at.y : this.world.box.min.y)) + this.eye_height;
    return {at, direction: this.farthest(at)};
  }

  // The level direction with the longest way to a surface.
  farthest(at) {
    let best = null;
    for (let k = 0; k < 24; ++k) {
      const direction = new Vector3(Math.cos(k * Math.PI / 12), -0.1, Math.sin(k * Math.PI / 12)).normalize();
      const ray = new Raycaster(at, direction);
      ray.firstHitOnly = true;
      const distance = ray.intersectObjects(this.world.meshesOf(() => true), false)[0]?.distance ?? 0;
      if (!best || distance > best.distance)
        best = {distance, direction};
    }
    return best.distance > 0 ? best.direction : this.towardsMiddle(at);
  }

  // Where nothing stands around: down to the floor.
  towardsMiddle(at) {
    const size = this.world.box.getSize(new Vector3());
    return (size.x > size.z ? new Vector3(1, -0.5, 0) : new Vector3(0, -0.5, 1))
      .multiplyScalar(at.x + at.z > this.world.center.x + this.world.center.z ? -1 : 1).setY(-0.5);
  }

  home(moves = false) {
    const {at, direction} = this.start();
    this.controls.zoomTo(1, moves);
    this.stand(at, direction, moves);
  }

  stand(at, direction, moves) {
    const to = at.clone().addScaledVector(direction.clone().normalize(), arm);
    this.controls.setLookAt(...at, ...to, moves);
  }

  direction() {
    return this.controls.getTarget(new Vector3()).sub(this.controls.getPosition(new Vector3())).normalize();
  }

  walkTo(floor) {
    this.stand(floor.clone().setY(floor.y + this.eye_height), this.direction().setY(0).lengthSq() > 1e-6
      ? this.direction() : new Vector3(1, 0, 0), true);
  }

  // A step forward, and to the right.
  step(forward, aside) {
    const direction = this.direction();
    const level = direction.clone().setY(0).normalize();
    const right = level.clone().cross(new Vector3(0, 1, 0));
    const at = this.controls.getPosition(new Vector3()).addScaledVector(level, 0.5 * forward)
      .addScaledVector(right, 0.5 * aside);
    this.stand(at, direction, true);
  }

  // Looks at a surface from here if one sees its front, else from before it.
  show(item) {
    const at = this.controls.getPosition(new Vector3());
    const middle = item.place.clone();
    if (item.normal && item.normal.dot(at.clone().sub(middle)) < 0.2) {
      at.copy(middle).addScaledVector(item.normal, 2.5);
      const floor = this.floorBelow(at.clone().setY(middle.y + 0.5));
      if (Math.abs(item.normal.y) < 0.5)
        at.y = floor === null ? middle.y : floor + this.eye_height;
    }
    this.stand(at, middle.sub(at), true);
  }

  opacityOf() { return 1; }

  setClipping() {
    this.camera.near = 0.03;
    this.camera.far = 3 * this.world.radius + this.camera.position.distanceTo(this.world.center);
    this.camera.updateProjectionMatrix();
  }
}
