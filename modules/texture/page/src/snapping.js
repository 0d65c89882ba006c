// The corner or edge next to the pointer, among those that are seen.

import {Vector2, Vector3} from 'three';

const reach = {mouse: 14, touch: 26, pen: 18}; // pixels
const sharp = Math.cos(Math.PI / 6); // a corner turns by more than this

function isCorner(loop, i) {
  const before = loop[(i + loop.length - 1) % loop.length], after = loop[(i + 1) % loop.length];
  const a = loop[i].clone().sub(before).normalize(), b = after.clone().sub(loop[i]).normalize();
  return a.dot(b) < sharp;
}

export class Snapping {
  constructor(world) {
    this.world = world;
    this.loops = world.items.planes.map(item => item.corners.map(loop => ({
      loop, corners: loop.map((_, i) => isCorner(loop, i))})));
  }

  // pointer: {x, y} in pixels; hit: what the ray of the pointer meets, or null
  at(pointer, view, ray, hit, kind) {
    const found = this.nearest(pointer, view, reach[kind] ?? reach.mouse);
    for (const candidate of found)
      if (this.isSeen(candidate.point, ray, view))
        return candidate;
    return hit ? {point: hit.point, item: hit.item, snap: null} : null;
  }

  // Corners, then edges, each by their distance.
  nearest(pointer, view, pixels) {
    const corners = [], edges = [];
    const onScreen = place => {
      const p = place.clone().project(view.camera);
      return new Vector3((p.x + 1) / 2 * window.innerWidth, (1 - p.y) / 2 * window.innerHeight, p.z);
    };
    const target = new Vector2(pointer.x, pointer.y);
    this.world.items.planes.forEach((item, id) => {
      if (!this.world.isShown(item))
        return;
      for (const {loop, corners: is_corner} of this.loops[id]) {
        const screen = loop.map(onScreen);
        screen.forEach((a, i) => {
          const b = screen[(i + 1) % loop.length];
          if (a.z < -1 || a.z > 1 || b.z < -1 || b.z > 1)
            return;
          const off = Math.hypot(a.x - target.x, a.y - target.y);
          if (is_corner[i] && off < pixels)
            corners.push({off, point: loop[i].clone(), item, snap: 'corner'});
          const edge = new Vector2(b.x - a.x, b.y - a.y);
          const t = target.clone().sub(a).dot(edge) / (edge.lengthSq() || 1);
          if (t <= 0 || t >= 1)
            return;
          const beside = Math.hypot(a.x + t * edge.x - target.x, a.y + t * edge.y - target.y);
          if (beside < pixels * 0.7)
            edges.push({off: beside, item, snap: 'edge',
                        point: placeAlong(loop[i], loop[(i + 1) % loop.length], t, view.camera)});
        });
      }
    });
    const byDistance = (a, b) => a.off - b.off;
    return [...corners.sort(byDistance).slice(0, 6), ...edges.sort(byDistance).slice(0, 6)];
  }

  // Is nothing before it?
  isSeen(point, ray, view) {
    const screen = point.clone().project(view.camera);
    ray.setFromCamera(new Vector2(screen.x, screen.y), view.camera);
    const distance = ray.ray.origin.distanceTo(point);
    const hit = this.world.hit(ray);
    return !hit || hit.distance > distance * 0.99 - 0.03;
  }
}

// The place on an edge that is drawn at a share t of its length on the screen.
function placeAlong(a, b, t, camera) {
  const depth = place => camera.isPerspectiveCamera
    ? -place.clone().applyMatrix4(camera.matrixWorldInverse).z : 1;
  const [u, v] = [(1 - t) / depth(a), t / depth(b)];
  return a.clone().multiplyScalar(u / (u + v)).addScaledVector(b, v / (u + v));
}
