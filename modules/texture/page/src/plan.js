// The view from above: floors as they are, walls cut, ceilings left out.

import {BufferGeometry, DoubleSide, Float32BufferAttribute, Group, Mesh, MeshBasicMaterial,
        OrthographicCamera, Vector3} from 'three';

import {actions, newControls} from './controls.js';
import {freeArea} from './fitting.js';
import {axesOf, boundsOf, cutAt, flatLoop} from './polygons.js';

const cut_height = 1.2, wall_thickness = 0.07; // metres
const least_thickness = 3.5; // pixels of a wall in the whole plan

// Where a plan cuts a wall: pairs of places on it, level, and whether it reaches that height.
function cutOf(item) {
  const axes = axesOf(item.normal);
  const loops = item.loops.map(loop => flatLoop(loop, axes));
  const [, bottom, , top] = boundsOf(loops);
  const is_full = top - bottom > cut_height + 0.1;
  const height = is_full ? bottom + cut_height : (bottom + top) / 2;
  const on_plane = item.place.dot(item.normal);
  const placeAt = x => new Vector3().addScaledVector(axes[0], x).addScaledVector(axes[1], height)
    .addScaledVector(item.normal, on_plane);
  return {is_full, parts: cutAt(loops, height).map(part => part.map(placeAt))};
}

// A strip behind the face of each wall, at one height.
function stripsOf(cuts, height, thickness) {
  const corners = [];
  for (const {parts, item} of cuts)
    for (const [from, to] of parts) {
      const behind = item.normal.clone().setY(0).normalize().multiplyScalar(-thickness);
      const [a, b] = [from, to].map(p => p.clone().setY(height));
      const [c, d] = [a, b].map(p => p.clone().add(behind));
      for (const p of [a, b, c, b, d, c])
        corners.push(...p);
    }
  return new BufferGeometry().setAttribute('position', new Float32BufferAttribute(corners, 3));
}

// Walls in the plan: dark where the cut reaches them, else grey.
class Walls {
  constructor(world) {
    this.top = world.box.max.y;
    this.cuts = world.items.planes
      .filter(item => Math.abs(item.normal.y) < 0.3 && item.area > 0.05 && !world.fragments.has(item.id))
      .map(item => ({item, ...cutOf(item)}));
    this.group = new Group();
    this.group.visible = false;
    for (const colour of [0x2b3542, 0x8c97a5])
      this.group.add(new Mesh(new BufferGeometry(),
                              new MeshBasicMaterial({color: colour, side: DoubleSide, toneMapped: false})));
  }

  setThickness(thickness) {
    this.group.children.forEach((mesh, i) => {
      mesh.geometry.dispose();
      mesh.geometry = stripsOf(this.cuts.filter(cut => cut.is_full === (i === 0)), this.top + 0.2 - 0.1 * i, thickness);
    });
  }
}

export class Plan {
  constructor(world, canvas) {
    this.name = 'plan';
    this.hint = 'drag: move · wheel: nearer · click: what it is';
    this.world = world;
    this.camera = new OrthographicCamera(-1, 1, 1, -1, 0, 100);
    this.controls = newControls(this.camera, canvas);
    this.controls.mouseButtons.left = this.controls.mouseButtons.right = actions.TRUCK;
    this.controls.mouseButtons.wheel = actions.ZOOM;
    this.controls.touches.one = actions.TOUCH_TRUCK;
    this.controls.touches.two = actions.TOUCH_ZOOM_TRUCK;
    this.controls.touches.three = actions.NONE;
    this.controls.dollyToCursor = true;
    this.controls.maxPolarAngle = 0;
    this.controls.maxZoom = 1e4;
    this.walls = new Walls(world);
  }

  resize(width, height) {
    Object.assign(this.camera, {left: -width / 2, right: width / 2, top: height / 2, bottom: -height / 2});
    this.camera.updateProjectionMatrix();
  }

  // The longer side of the map along that of the window.
  home(moves = false) {
    const area = freeArea();
    const size = this.world.box.getSize(new Vector3());
    const width = (area.right - area.left) / 2 * (this.camera.right - this.camera.left);
    const height = (area.top - area.bottom) / 2 * (this.camera.top - this.camera.bottom);
    const isTurned = Math.max(size.x, 1e-3) > Math.max(size.z, 1e-3) !== width > height;
    const [across, along] = isTurned ? [size.z, size.x] : [size.x, size.z];
    const zoom = 0.96 * Math.min(width / Math.max(across, 0.1), height / Math.max(along, 0.1));
    // the middle of the map comes to the middle of the free part of the window
    const x = -(area.left + area.right) / 4 * (this.camera.right - this.camera.left) / zoom;
    const y = (area.top + area.bottom) / 4 * (this.camera.top - this.camera.bottom) / zoom;
    const center = this.world.center;
    const at = isTurned ? [center.x + y, center.z - x] : [center.x + x, center.z + y];
    this.walls.setThickness(Math.max(wall_thickness, least_thickness / zoom));
    this.look(at, zoom, isTurned ? Math.PI / 2 : 0, moves);
  }

  look([x, z], zoom, azimuth, moves) {
    const top = this.world.box.max.y;
    this.controls.normalizeRotations();
    this.controls.rotateTo(azimuth, 0, moves);
    this.controls.moveTo(x, top, z, moves);
    this.controls.dollyTo(this.world.radius + 2, moves);
    this.controls.zoomTo(zoom, moves);
  }

  show(item) {
    this.controls.moveTo(item.place.x, this.world.box.max.y, item.place.z, true);
  }

  opacityOf(item) { return item.role === 'ceiling' || item.normal.y < 0 ? 0 : 1; }

  setClipping() {
    this.camera.near = 0;
    this.camera.far = 2 * this.world.radius + 10 + this.camera.position.y - this.world.box.min.y;
    this.camera.updateProjectionMatrix();
  }
}
