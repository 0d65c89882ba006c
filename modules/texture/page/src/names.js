// Words and sizes of what is in the map. Newer maps have them; of older ones they are guessed
// by the directions and places of the planes.

import {axesOf, boundsOf, flatLoop} from './polygons.js';

export const metres = (value, digits = 2) => value.toFixed(digits);

export const millimetres = value => `${metres(1000 * value, 1)} mm`;

export const squareMetres = value => `${metres(value, value < 10 ? 2 : 1)} m²`;

// 1234567 as '1,234,567'; toLocaleString takes 20 ms to begin.
export const countText = value => String(Math.round(value)).replace(/\B(?=(\d{3})+$)/g, ',');

const isSize = size => Array.isArray(size) && size.some(side => side > 0);

// [7.1, 4.0] as '7.1 × 4.0 m'; sides that nobody knows are left out
export function sizeText(size, digits = 1) {
  if (!isSize(size))
    return '';
  return size.map(side => Number.isFinite(side) ? metres(side, digits) : '?').join(' × ') + ' m';
}

export const capital = text => text.charAt(0).toUpperCase() + text.slice(1);

// Width along the level and height of a plane, metres.
export function sizeOfPlane(plane, frame) {
  if (isSize(plane.size))
    return plane.size;
  if (plane.polygons.length === 0)
    return null;
  const axes = axesOf(frame.direction(plane.coefficients));
  const [left, bottom, right, top] = boundsOf(plane.polygons.map(polygon =>
    flatLoop(polygon.outer.map(p => frame.place(p)), axes)));
  const size = [right - left, top - bottom];
  return Math.abs(frame.direction(plane.coefficients).y) > 0.95 ? size.sort((a, b) => b - a) : size;
}

// The numbers of the rooms that list a plane.
function roomsOf(map, id) {
  return (map.rooms ?? []).flatMap((room, number) => room.planes.includes(id) ? [number] : []);
}

function heightOf(plane, frame) {
  const heights = plane.polygons.flatMap(polygon => polygon.outer).map(p => frame.place(p).y);
  return [Math.min(...heights), Math.max(...heights)];
}

// The heights of floor and ceiling, by the largest level planes; where a map has several
// storeys, of one of them.
function levelHeights(map, frame) {
  const largest = {1: null, '-1': null};
  for (const plane of map.planes) {
    const up = frame.direction(plane.coefficients).y;
    const side = Math.sign(up);
    if (Math.abs(up) > 0.95 && plane.polygons.length > 0 && !(largest[side]?.area >= plane.area))
      largest[side] = plane;
  }
  const height = plane => plane ? heightOf(plane, frame)[0] : null;
  return {floor: height(largest[1]), ceiling: height(largest[-1])};
}

function guessedRole(map, id, frame, heights) {
  const plane = map.planes[id];
  if (plane.polygons.length === 0)
    return 'other';
  const up = frame.direction(plane.coefficients).y;
  const [bottom, top] = heightOf(plane, frame);
  const bounds_a_room = roomsOf(map, id).length > 0;
  if (up > 0.95)
    return bounds_a_room || Math.abs(bottom - heights.floor) < 0.2 ? 'floor' : 'furniture';
  if (up < -0.95)
    return bounds_a_room || bottom > (heights.floor ?? -Infinity) + 1.9 ? 'ceiling' : 'other';
  if (Math.abs(up) < 0.2)
    return bounds_a_room || (top - bottom > 1.5 && plane.area > 1) ? 'wall' : 'other';
  return 'other';
}

const nouns = {furniture: 'level surface', other: 'surface'};

// {name, role} of each plane
export function namesOfPlanes(map, frame) {
  const heights = levelHeights(map, frame);
  return map.planes.map((plane, id) => {
    const role = plane.role ?? guessedRole(map, id, frame, heights);
    if (plane.name)
      return {name: plane.name, role};
    const rooms = roomsOf(map, id);
    const noun = capital(nouns[role] ?? role);
    return {role, name: rooms.length === 1 ? `${noun} of room ${rooms[0] + 1}` : `${noun} ${id}`};
  });
}

// An opening or a recess as on the card of its wall, 'door 0.97 × 2.40 m', or of a room, with
// its name.
const sizedText = (name, size) => {
  const known = size.filter(side => Number.isFinite(side));
  return known.length === 2 ? `${name} ${sizeText(known, 2)}` : `${name} ${metres(known[0] ?? 0)} m wide`;
};

export function openingText(opening, has_name = false) {
  const width = Math.hypot(...opening.to.map((x, i) => x - opening.from[i]));
  const height = Number.isFinite(opening.top) ? opening.top - Math.max(0, opening.bottom ?? 0) : null;
  return sizedText(has_name && opening.name ? opening.name : opening.kind,
                   isSize(opening.size) ? opening.size : [width, height]);
}

// What it is, without the room
export function recessText(recess) {
  const what = recess.name ? recess.name.split(/ (?:of|in|between) /)[0].toLowerCase() : 'recess';
  return sizedText(what, recess.size.slice(0, 2));
}
