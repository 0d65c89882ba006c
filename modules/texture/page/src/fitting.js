// Where a camera has to stand so that places are within a part of the window.

import {Vector3} from 'three';

// The part of the window that no panel covers, from -1 to 1: {left, right, bottom, top}.
export function freeArea() {
  const width = window.innerWidth, height = window.innerHeight;
  const side = document.getElementById('side').getBoundingClientRect();
  const views = document.getElementById('views').getBoundingClientRect();
  const is_wide = getComputedStyle(document.getElementById('contents')).display === 'none';
  const left = is_wide ? side.right + 12 : 12;
  const [top, bottom] = is_wide ? [views.bottom + 12, height - 40] : [64, views.top - 10];
  return {left: 2 * left / width - 1, right: 1 - 2 * 16 / width,
          top: 1 - 2 * top / height, bottom: 1 - 2 * bottom / height};
}

// The axes of a camera that looks along a direction: right, up, back.
function cameraAxes(direction) {
  const back = direction.clone().negate().normalize();
  const right = new Vector3(0, 1, 0).cross(back);
  if (right.lengthSq() < 1e-9)
    right.set(1, 0, 0);
  right.normalize();
  return [right, back.clone().cross(right), back];
}

// The nearest position from which a perspective camera that looks along a direction has all
// places in the area; tangent: of half its vertical angle.
export function fittingPosition(places, direction, tangent, aspect, area) {
  const [right, up, back] = cameraAxes(direction);
  const slopes = [area.right * tangent * aspect, -area.left * tangent * aspect,
                  area.top * tangent, -area.bottom * tangent];
  const most = [-Infinity, -Infinity, -Infinity, -Infinity];
  for (const place of places) {
    const x = place.dot(right), y = place.dot(up), z = place.dot(back);
    most[0] = Math.max(most[0], x + z * slopes[0]);
    most[1] = Math.max(most[1], -x + z * slopes[1]);
    most[2] = Math.max(most[2], y + z * slopes[2]);
    most[3] = Math.max(most[3], -y + z * slopes[3]);
  }
  const z = Math.max((most[0] + most[1]) / (slopes[0] + slopes[1]),
                     (most[2] + most[3]) / (slopes[2] + slopes[3]));
  const middle = (i, k) => (most[i] - z * slopes[i] + z * slopes[k] - most[k]) / 2;
  return new Vector3().addScaledVector(right, middle(0, 1)).addScaledVector(up, middle(2, 3))
    .addScaledVector(back, z);
}
