// What the list, the cards and the links speak of: planes, cylinders, boxes and rooms, each as
// {kind, id, name, line, openings, rows, loops, place, normal}. Loops are outlines in the scene.

import {Vector3} from 'three';

import {capital, countText, millimetres, namesOfPlanes, openingText, recessText, sizeOfPlane, sizeText,
        squareMetres} from './names.js';
import {simplified} from './polygons.js';
import {errorsOf} from './uncertainty.js';

const digits = (values, count) => values.map(x => Number(x).toFixed(count)).join(', ');

const joined = parts => parts.filter(part => part).join(', ');

function middleOf(loops) {
  const middle = new Vector3();
  let count = 0;
  for (const place of loops.flat()) {
    middle.add(place);
    ++count;
  }
  return middle.divideScalar(Math.max(1, count));
}

function loopsOf(polygons, frame) {
  return polygons.flatMap(polygon => [polygon.outer, ...(polygon.holes ?? [])])
    .map(loop => loop.map(p => frame.place(p)));
}

const bitRows = patch => Number.isFinite(patch.saved_bits)
  ? [['saved', `${countText(patch.saved_bits)} bits of the description`]] : [];

function planeItem(map, id, named, frame) {
  const plane = map.planes[id];
  const [a, b, c, d] = plane.coefficients;
  const loops = loopsOf(plane.polygons, frame);
  const rows = [['number', `plane ${id}`],
                ['equation', `(${digits([a, b, c], 4)}) · x = ${(-d).toFixed(4)} m`],
                ['points', countText(plane.support)]];
  if (plane.observations?.length > 0)
    rows.push(['seen by', `${plane.observations.length} observations`]);
  return {kind: 'plane', id, name: named.name, role: named.role, loops,
          corners: loops.map(loop => simplified(loop, 0.01)),
          line: joined([squareMetres(plane.area), sizeText(sizeOfPlane(plane, frame)),
                        Number.isFinite(plane.rmse) && `noise ${millimetres(plane.rmse)}`]),
          openings: [...(map.openings ?? []).filter(opening => opening.planes.includes(id))
                       .map(opening => openingText(opening)),
                     ...(map.recesses ?? []).filter(recess => recess.wall === id).map(recessText)],
          rows: [...rows, ...bitRows(plane)], area: plane.area,
          place: middleOf(loops), normal: frame.direction([a, b, c]),
          errors: errorsOf(plane, frame)};
}

// The arc at the lower end, and back along the upper one.
function cylinderLoop(cylinder, frame) {
  const axis = frame.direction(cylinder.axis_direction), point = frame.place(cylinder.axis_point);
  const [u, v] = cylinder.axes.map(array => frame.direction(array));
  const steps = 16;
  const arcAt = along => Array.from({length: steps + 1}, (_, i) => {
    const angle = cylinder.arc * (i / steps - 0.5);
    return point.clone().addScaledVector(axis, along)
      .addScaledVector(u, cylinder.radius * Math.cos(angle))
      .addScaledVector(v, cylinder.radius * Math.sin(angle));
  });
  return [...arcAt(cylinder.extent[0]), ...arcAt(cylinder.extent[1]).reverse()];
}

function cylinderItem(map, id, frame) {
  const cylinder = map.cylinders[id];
  const loops = [cylinderLoop(cylinder, frame)];
  const [diameter, length] =
    cylinder.size ?? [2 * cylinder.radius, cylinder.extent[1] - cylinder.extent[0]];
  const outwards = frame.direction(cylinder.axes[0]);
  return {kind: 'cylinder', id, name: cylinder.name ?? `Cylinder ${id}`, role: 'cylinder', loops,
          corners: loops, openings: [], area: cylinder.area,
          line: joined([squareMetres(cylinder.area), `⌀ ${diameter.toFixed(2)} × ${length.toFixed(2)} m`,
                        Number.isFinite(cylinder.rmse) && `noise ${millimetres(cylinder.rmse)}`]),
          rows: [['number', `cylinder ${id}`], ['axis', digits(cylinder.axis_direction, 4)],
                 ['points', countText(cylinder.support)], ...bitRows(cylinder)],
          place: middleOf(loops), normal: cylinder.hollow ? outwards.negate() : outwards};
}

const box_edges = [0, 1, 2, 3, 4, 5, 6, 7].flatMap(corner =>
  [1, 2, 4].filter(bit => !(corner & bit)).map(bit => [corner, corner | bit]));

function boxItem(map, id, frame) {
  const box = map.boxes[id];
  const center = frame.place(box.center), axes = box.axes.map(array => frame.direction(array));
  const corner = bits => axes.reduce(
    (place, axis, k) => place.addScaledVector(axis, (bits >> k & 1 ? 0.5 : -0.5) * box.size[k]),
    center.clone());
  return {kind: 'box', id, name: box.name ?? `Box ${id}`, role: 'box', openings: [],
          loops: box_edges.map(ends => ends.map(corner)), corners: [],
          line: sizeText(box.size, 2), area: 0,
          rows: [['number', `box ${id}`], ...bitRows(box)], place: center, normal: null};
}

function roomItem(map, id, planes, frame) {
  const room = map.rooms[id];
  const floors = room.planes.map(plane => planes[plane]).filter(item => item?.role === 'floor');
  const openings = room.openings.map(k => map.openings?.[k]).filter(opening => opening);
  return {kind: 'room', id, name: room.name ?? `Room ${id + 1}`, role: 'room',
          loops: floors.flatMap(item => item.loops), corners: [],
          line: joined([squareMetres(room.area), sizeText(room.size)]), area: room.area,
          openings: openings.map(opening => openingText(opening, true)),
          rows: [['floor seen', squareMetres(room.seen_area)], ['surfaces', `${room.planes.length}`]],
          place: frame.place(room.center), normal: null, planes: room.planes};
}

export class Items {
  constructor(map, frame) {
    this.planes = namesOfPlanes(map, frame).map((named, id) => planeItem(map, id, named, frame));
    this.cylinders = (map.cylinders ?? []).map((_, id) => cylinderItem(map, id, frame));
    this.boxes = (map.boxes ?? []).map((_, id) => boxItem(map, id, frame));
    this.rooms = (map.rooms ?? []).map((_, id) => roomItem(map, id, this.planes, frame));
    for (const item of this.all())
      item.name = capital(item.name);
  }

  all() { return [...this.rooms, ...this.planes, ...this.cylinders, ...this.boxes]; }

  find(kind, id) { return this.all().find(item => item.kind === kind && item.id === id) ?? null; }
}
