// The surfaces of map.glb, apart by plane and cylinder, in the frame of the scene.

import {BufferAttribute, BufferGeometry, Group, Mesh, Vector3} from 'three';

import {Belonging} from './belonging.js';
import {kindTexture, prepareTexture, textureMaterial, unseenMaterial} from './colours.js';
import {KindPlaces, picturesOf} from './kinds.js';

const numberIn = name => Number(/\d+/.exec(name ?? '')?.[0] ?? -1);

// The triangles of a mesh of map.glb: callback (three places in the scene, texture coordinates).
function eachTriangle(mesh, frame, callback) {
  const {position, uv} = mesh.geometry.attributes;
  const index = mesh.geometry.index;
  const to_scene = frame.of_glb.clone().multiply(mesh.matrixWorld);
  const count = index ? index.count : position.count;
  for (let i = 0; i + 2 < count; i += 3) {
    const corners = [0, 1, 2].map(k => index ? index.getX(i + k) : i + k);
    const places = corners.map(k => new Vector3().fromBufferAttribute(position, k).applyMatrix4(to_scene));
    callback(places, uv ? corners.flatMap(k => [uv.getX(k), uv.getY(k)]) : [0, 0, 0, 0, 0, 0]);
  }
}

// Triangles that share a material, and are drawn or hidden together.
class Part {
  constructor() {
    this.positions = [];
    this.places = [];
    this.kinds = [];
    this.normals = [];
  }

  add(places, coordinates, kinds) {
    const normal = new Vector3().subVectors(places[1], places[0])
      .cross(new Vector3().subVectors(places[2], places[0])).normalize();
    for (const place of places) {
      this.positions.push(place.x, place.y, place.z);
      this.normals.push(normal.x, normal.y, normal.z);
    }
    this.places.push(...coordinates);
    this.kinds.push(...kinds);
  }

  geometry() {
    const geometry = new BufferGeometry();
    const set = (name, values, size) =>
      geometry.setAttribute(name, new BufferAttribute(new Float32Array(values), size));
    set('position', this.positions, 3);
    set('normal', this.normals, 3);
    set('uv', this.places, 2);
    set('kind', this.kinds, 2);
    return geometry;
  }
}

// All triangles, sorted by surface, page of colours and page of kinds.
class SurfaceParts {
  constructor() { this.parts = new Map(); }

  at(owner, page, kinds) {
    const key = `${owner?.kind} ${owner?.id} ${page} ${kinds}`;
    if (!this.parts.has(key))
      this.parts.set(key, {owner, page, kinds, part: new Part()});
    return this.parts.get(key).part;
  }
}

async function kindTextures(data) {
  const textures = {};
  for (const [name, png] of Object.entries(data.kinds))
    textures[name] = await kindTexture(png);
  return textures;
}

// What the material of a surface depends on: its page of colours, which may be none.
function materialOf(entry, pages, kinds) {
  if (entry.page === null)
    return unseenMaterial();
  return textureMaterial(pages.get(entry.page), entry.kinds && kinds[entry.kinds]);
}

// node: 'map' of map.glb. Returns surfaces {kind, id, group}, in the order of the file.
export async function surfacesOf(data, node, frame, renderer) {
  const kinds = await kindTextures(data);
  const sizeOf = name => kinds[name] && [kinds[name].image.width, kinds[name].image.height];
  const pictures = picturesOf(data.map).map(p => ({...p, image: numberIn(p.image)}));
  const belonging = new Belonging(data.map, frame);
  const sorted = new SurfaceParts();
  const pages = new Map();
  const has_colours = pictures.length > 0;
  node.traverse(mesh => {
    if (!mesh.isMesh)
      return;
    const texture = mesh.material.emissiveMap ?? mesh.material.map;
    const page = numberIn(mesh.material.name);
    if (texture)
      prepareTexture(texture, renderer);
    pages.set(page, texture);
    const places_of_kinds = new KindPlaces(
      pictures, {name: page, width: texture?.image.width ?? 1, height: texture?.image.height ?? 1});
    eachTriangle(mesh, frame, (places, coordinates) => {
      const kind = places_of_kinds.of(coordinates, sizeOf);
      const owner = belonging.of(...places);
      const is_coloured = texture && (kind.has_picture || !has_colours);
      sorted.at(owner, is_coloured ? page : null, kind.name).add(places, coordinates, kind.coordinates);
    });
  });
  return groupsOf(sorted, pages, kinds);
}

function groupsOf(sorted, pages, kinds) {
  const surfaces = new Map();
  for (const entry of sorted.parts.values()) {
    const key = `${entry.owner?.kind} ${entry.owner?.id}`;
    if (!surfaces.has(key))
      surfaces.set(key, {kind: entry.owner?.kind ?? 'other', id: entry.owner?.id ?? -1,
                         group: new Group(), is_unseen: false});
    const surface = surfaces.get(key);
    const mesh = new Mesh(entry.part.geometry(), materialOf(entry, pages, kinds));
    mesh.userData.surface = surface;
    surface.group.add(mesh);
    surface.is_unseen ||= entry.page === null || entry.kinds !== null;
  }
  return [...surfaces.values()];
}
