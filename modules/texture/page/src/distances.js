// Distances between what was picked: {point, item, snap}, where snap is 'corner', 'edge' or null.

import {MathUtils, Vector3} from 'three';

import {axesOf, boundsOf, flatLoop, isWithin} from './polygons.js';
import {uncertainty} from './uncertainty.js';

const largest_angle = 5; // degrees between planes that count as parallel
const steps = 64;        // of the grid over the overlap

// "3.412 m ± 4.2 mm", of two standard deviations.
function lengthText(length, first, second, ends) {
  const known = uncertainty(first, second, ends);
  if (!known)
    return `${length.toFixed(3)} m`;
  return `${length.toFixed(3)} m ± ${known.at_least ? 'at least ' : ''}${(2000 * known.sigma).toFixed(1)} mm`;
}

// {ends, length, text, more}
export function betweenPoints(first, second) {
  const difference = second.point.clone().sub(first.point);
  const length = difference.length();
  const level = Math.hypot(difference.x, difference.z), upright = Math.abs(difference.y);
  const ends = [first.point, second.point];
  return {ends, length, text: lengthText(length, first, second, ends),
          more: upright < 0.0005 ? 'level' : level < 0.0005 ? 'upright'
            : `level ${level.toFixed(3)} m, upright ${upright.toFixed(3)} m`};
}

// The middle of what two sets of loops have in common, or of the place between them.
function middleOfOverlap(first, second) {
  const [a, b] = [boundsOf(first), boundsOf(second)];
  const low = [Math.max(a[0], b[0]), Math.max(a[1], b[1])];
  const high = [Math.min(a[2], b[2]), Math.min(a[3], b[3])];
  let count = 0, x = 0, y = 0;
  if (low[0] < high[0] && low[1] < high[1])
    for (let i = 0; i < steps; ++i)
      for (let k = 0; k < steps; ++k) {
        const at = [low[0] + (i + 0.5) / steps * (high[0] - low[0]), low[1] + (k + 0.5) / steps * (high[1] - low[1])];
        if (isWithin(first, at) && isWithin(second, at)) {
          ++count;
          x += at[0];
          y += at[1];
        }
      }
  return count > 0 ? {at: [x / count, y / count], overlaps: true}
                   : {at: [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2], overlaps: false};
}

// The same as betweenPoints, or {refused} where the planes are not parallel.
export function betweenPlanes(first, second) {
  const [n, m] = [first.item.normal, second.item.normal];
  const side = Math.sign(n.dot(m)) || 1;
  const angle = MathUtils.radToDeg(Math.acos(Math.min(1, Math.abs(n.dot(m)))));
  if (angle > largest_angle)
    return {refused: `not parallel: ${angle.toFixed(1)}° between them`, angle};
  const normal = n.clone().addScaledVector(m, side).normalize();
  const axes = axesOf(normal);
  const {at, overlaps} = middleOfOverlap(...[first, second].map(
    pick => pick.item.loops.map(loop => flatLoop(loop, axes))));
  const foot = new Vector3().addScaledVector(axes[0], at[0]).addScaledVector(axes[1], at[1]);
  const ends = [first, second].map(pick => {
    const {normal: own, place} = pick.item;
    const along = own.dot(place.clone().sub(foot)) / own.dot(normal);
    return foot.clone().addScaledVector(normal, along);
  });
  const length = ends[0].distanceTo(ends[1]);
  const parallel = angle < 0.05 ? 'parallel' : `${angle.toFixed(1)}° off parallel`;
  return {ends, length, text: lengthText(length, first, second, ends),
          more: overlaps ? `${parallel}, at the middle of their overlap` : `${parallel}, they do not overlap`};
}
