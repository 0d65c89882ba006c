// Where the camera of a page is, by its address, and where it shows a place: computed here, so
// that a click goes where a person would see the place.

const minus = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = a => a.map(x => x / Math.hypot(...a));

const angles = {dollhouse: 36, inside: 70}; // degrees, vertical

// In the frame of the map, whose y points down.
export async function cameraIn(page) {
  const values = Object.fromEntries((await page.value('location.hash')).slice(1).split('&').map(part => part.split('=')));
  const numbers = key => values[key].split(',').map(Number);
  return {view: values.view, at: numbers('at'), to: numbers('to'), zoom: Number(values.zoom ?? 1), size: page.size};
}

export function pixelOf(place, {view, at, to, zoom, size}) {
  const forward = view === 'plan' ? [0, 1, 0] : unit(minus(to, at));
  const is_turned = size.height > size.width; // the longer side of the room along the window's
  const up = view !== 'plan' ? [0, -1, 0] : is_turned ? [-1, 0, 0] : [0, 0, 1];
  const right = unit(cross(forward, up));
  const upwards = cross(right, forward);
  const offset = minus(place, at);
  const [x, y, z] = [right, upwards, forward].map(axis => dot(offset, axis));
  const slope = Math.tan(angles[view] * Math.PI / 360);
  const least = Math.tan(27.5 * Math.PI / 180) * size.height / size.width; // of a narrow window inside
  const tangent = view === 'inside' ? Math.min(Math.tan(47.5 * Math.PI / 180), Math.max(slope, least)) : slope;
  const scale = view === 'plan' ? zoom : size.height / 2 / tangent / z * zoom;
  return [size.width / 2 + scale * x, size.height / 2 - scale * y];
}
