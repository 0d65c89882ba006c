// Polygons of planes as loops of places in the scene, and the same in two dimensions.

import {Vector3} from 'three';

// Two axes of a plane: the first one level, the second one upright as far as it goes.
export function axesOf(normal) {
  const up = new Vector3(0, 1, 0);
  const level = up.clone().cross(normal);
  if (level.length() < 0.05)
    level.set(1, 0, 0).addScaledVector(normal, -normal.x);
  level.normalize();
  return [level, normal.clone().cross(level)];
}

// The ends of all edges of closed loops, in pairs.
export const edgesOf = loops =>
  loops.flatMap(loop => loop.flatMap((place, i) => [place, loop[(i + 1) % loop.length]]));

export const flatLoop = (loop, [u, v]) => loop.map(p => [p.dot(u), p.dot(v)]);

export function isWithin(loops, [x, y]) {
  let inside = false;
  for (const loop of loops)
    for (let i = 0, j = loop.length - 1; i < loop.length; j = i++) {
      const [ax, ay] = loop[i], [bx, by] = loop[j];
      if ((ay > y) !== (by > y) && x < (bx - ax) * (y - ay) / (by - ay) + ax)
        inside = !inside;
    }
  return inside;
}

export function boundsOf(loops) {
  const bounds = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of loops.flat()) {
    bounds[0] = Math.min(bounds[0], x);
    bounds[1] = Math.min(bounds[1], y);
    bounds[2] = Math.max(bounds[2], x);
    bounds[3] = Math.max(bounds[3], y);
  }
  return bounds;
}

// The parts of a level line at height y that are within the loops: pairs of x.
export function cutAt(loops, y) {
  const crossings = [];
  for (const loop of loops)
    for (let i = 0, j = loop.length - 1; i < loop.length; j = i++) {
      const [ax, ay] = loop[i], [bx, by] = loop[j];
      if ((ay > y) !== (by > y))
        crossings.push((bx - ax) * (y - ay) / (by - ay) + ax);
    }
  crossings.sort((a, b) => a - b);
  const parts = [];
  for (let i = 0; i + 1 < crossings.length; i += 2)
    parts.push([crossings[i], crossings[i + 1]]);
  return parts;
}

// A loop without the corners that are less than a tolerance beside the line of their
// neighbours (Douglas and Peucker, from its two places that are farthest apart).
export function simplified(loop, tolerance) {
  if (loop.length < 4)
    return loop;
  let far = 0;
  for (let i = 1; i < loop.length; ++i)
    if (loop[i].distanceToSquared(loop[0]) > loop[far].distanceToSquared(loop[0]))
      far = i;
  const kept = new Set([0, far]);
  const ranges = [[0, far], [far, loop.length]];
  const line = new Vector3(), beside = new Vector3();
  while (ranges.length > 0) {
    const [first, last] = ranges.pop();
    const a = loop[first];
    line.subVectors(loop[last % loop.length], a);
    const length = line.length() || 1;
    let worst = tolerance, at = -1;
    for (let i = first + 1; i < last; ++i) {
      const off = beside.subVectors(loop[i], a).cross(line).length() / length;
      if (off > worst)
        [worst, at] = [off, i];
    }
    if (at >= 0) {
      kept.add(at);
      ranges.push([first, at], [at, last]);
    }
  }
  return [...kept].sort((a, b) => a - b).map(i => loop[i]);
}
