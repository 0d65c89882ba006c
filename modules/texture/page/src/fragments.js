// Planes that touch nothing: small pieces in the air, of which a map from few observations has
// many. They are a layer of their own.

import {Box3, Vector3} from 'three';

import {axesOf, flatLoop, isWithin} from './polygons.js';

const gap = 0.06;         // metres across which planes touch
const step = 0.25;        // metres between the places of an outline that are tried
const largest_share = 0.02; // of the area of all planes: more is no fragment

function placesAlong(loop) {
  const places = [];
  loop.forEach((a, i) => {
    const b = loop[(i + 1) % loop.length];
    const count = Math.min(200, Math.max(1, Math.ceil(a.distanceTo(b) / step)));
    for (let k = 0; k < count; ++k)
      places.push(a.clone().lerp(b, k / count));
  });
  return places;
}

function distanceToLoops(loops, [x, y]) {
  let least = Infinity;
  for (const loop of loops)
    for (let i = 0, j = loop.length - 1; i < loop.length; j = i++) {
      const [ax, ay] = loop[i], [bx, by] = loop[j];
      const dx = bx - ax, dy = by - ay;
      const t = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
      least = Math.min(least, Math.hypot(x - ax - t * dx, y - ay - t * dy));
    }
  return least;
}

class Piece {
  constructor(item) {
    this.item = item;
    this.axes = axesOf(item.normal);
    this.loops = item.corners.map(loop => flatLoop(loop, this.axes));
    this.places = item.corners.flatMap(placesAlong);
    this.box = new Box3().setFromPoints(this.places).expandByScalar(gap);
    this.offset = item.place.dot(item.normal);
  }

  touches(other) {
    return this.box.intersectsBox(other.box) && (this.reaches(other) || other.reaches(this));
  }

  // Is its outline at the other one?
  reaches(other) {
    return this.places.some(place => {
      if (!other.box.containsPoint(place) || Math.abs(place.dot(other.item.normal) - other.offset) > gap)
        return false;
      const flat = [place.dot(other.axes[0]), place.dot(other.axes[1])];
      return isWithin(other.loops, flat) || distanceToLoops(other.loops, flat) < gap;
    });
  }
}

class Groups {
  constructor(count) { this.parent = Array.from({length: count}, (_, i) => i); }

  of(i) {
    while (this.parent[i] !== i)
      i = this.parent[i] = this.parent[this.parent[i]];
    return i;
  }

  join(i, k) { this.parent[this.of(i)] = this.of(k); }
}

// The numbers of planes in groups that touch no other group, are small and bound no room.
export function fragmentsOf(map, planes) {
  const groups = new Groups(planes.length);
  for (const edge of map.edges ?? [])
    if (edge.planes?.length === 2)
      groups.join(edge.planes[0], edge.planes[1]);
  const pieces = planes.map(item => new Piece(item));
  for (let i = 0; i < pieces.length; ++i)
    for (let k = i + 1; k < pieces.length; ++k)
      if (groups.of(i) !== groups.of(k) && pieces[i].touches(pieces[k]))
        groups.join(i, k);
  const areas = new Map();
  planes.forEach((item, i) => areas.set(groups.of(i), (areas.get(groups.of(i)) ?? 0) + item.area));
  const all = planes.reduce((sum, item) => sum + item.area, 0);
  const main = [...areas].reduce((best, entry) => entry[1] > best[1] ? entry : best, [-1, -1])[0];
  const in_rooms = new Set((map.rooms ?? []).flatMap(room => room.planes).map(id => groups.of(id)));
  return new Set(planes.flatMap((item, i) => {
    const group = groups.of(i);
    return group !== main && !in_rooms.has(group) && areas.get(group) < largest_share * all ? [item.id] : [];
  }));
}

export function boxOf(items) {
  const box = new Box3();
  for (const place of items.flatMap(item => item.loops.flat()))
    box.expandByPoint(place);
  return box.isEmpty() ? new Box3(new Vector3(-1, -1, -1), new Vector3(1, 1, 1)) : box;
}
