// The surfaces of map.glb, apart by plane and cylinder, in the frame of the scene.

import {BufferAttribute, BufferGeometry, Group, Mesh, Vector3} from 'three';

import {Belonging} from './belonging.js';
import {detailMaterial, shade, textureMaterial, unseenMaterial} from './colours.js';
import {KindPlaces, picturesOf} from './kinds.js';
import {numberIn} from './textures.js';

// The triangles of a part of map.glb: callback (three places in the scene, texture coordinates),
// which are others at the next call.
function eachTriangle(geometry, to_scene, callback) {
  geometry.applyMatrix4(to_scene);
  const {position, uv} = geometry.attributes;
  const index = geometry.index;
  const count = index ? index.count : position.count;
  const places = [new Vector3(), new Vector3(), new Vector3()], coordinates = [0, 0, 0, 0, 0, 0];
  for (let i = 0; i + 2 < count; i += 3) {
    for (let k = 0; k < 3; ++k) {
      const corner = index ? index.getX(i + k) : i + k;
      places[k].fromBufferAttribute(position, corner);
      if (uv)
        [coordinates[2 * k], coordinates[2 * k + 1]] = [uv.getX(corner), uv.getY(corner)];
    }
    callback(places, coordinates);
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

// Materials by page of colours, which may be none, and page of kinds. Meshes share them, except
// those that fade.
class Materials {
  constructor(pages, textures, has_colours) {
    Object.assign(this, {pages, textures, has_colours, shared: new Map()});
  }

  made({page, kinds}) {
    return !this.has_colours ? detailMaterial()
         : page === null ? unseenMaterial()
                         : textureMaterial(this.pages.get(page), kinds && this.textures.kinds.get(kinds).texture);
  }

  of(entry) {
    const key = `${entry.page} ${entry.kinds}`;
    if (!this.shared.has(key))
      this.shared.set(key, this.made(entry));
    return this.shared.get(key);
  }
}

// node: 'map' of map.glb. Returns surfaces {kind, id, group}, in the order of the file.
export async function surfacesOf({map, has_colours}, node, frame, textures) {
  const pictures = picturesOf(map).map(p => ({...p, image: numberIn(p.image)}));
  const belonging = new Belonging(map, frame);
  const sorted = new SurfaceParts();
  const pages = new Map();
  const has_pictures = pictures.length > 0;
  const to_scene = frame.of_glb.clone().multiply(node.matrix);
  for (const part of node.parts) {
    const page = numberIn(part.material);
    const {texture, size} = part.image === null ? {texture: null, size: [1, 1]} : await textures.page(part);
    pages.set(page, texture);
    const kinds = new KindPlaces(pictures, {name: page, width: size[0], height: size[1]});
    eachTriangle(part.geometry, to_scene, (places, coordinates) => {
      const kind = kinds.of(coordinates, name => textures.kinds.get(name)?.size);
      const owner = belonging.of(...places);
      const is_coloured = texture && (kind.has_picture || !has_pictures);
      sorted.at(owner, is_coloured ? page : null, kind.name).add(places, coordinates, kind.coordinates);
    });
  }
  return groupsOf(map, sorted, new Materials(pages, textures, has_colours));
}

function roleOf(map, owner) {
  return owner?.kind === 'plane' ? map.planes[owner.id]?.role : 'furniture';
}

function groupsOf(map, sorted, materials) {
  const surfaces = new Map();
  for (const entry of sorted.parts.values()) {
    const key = `${entry.owner?.kind} ${entry.owner?.id}`;
    if (!surfaces.has(key))
      surfaces.set(key, {kind: entry.owner?.kind ?? 'other', id: entry.owner?.id ?? -1,
                         group: new Group(), is_unseen: false});
    const surface = surfaces.get(key);
    const whole = materials.of(entry);
    const geometry = entry.part.geometry();
    if (!materials.has_colours)
      shade(geometry, roleOf(map, entry.owner));
    const mesh = new Mesh(geometry, whole);
    mesh.userData = {surface, whole, fading: () => mesh.userData.faded ??= materials.made(entry)};
    surface.group.add(mesh);
    surface.is_unseen ||= materials.has_colours && (entry.page === null || entry.kinds !== null);
  }
  return [...surfaces.values()];
}
