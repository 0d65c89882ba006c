// All that is drawn, and what the views, cards and measures ask about it.

import {BufferGeometry, Group, Line, LineBasicMaterial, LineSegments, Matrix4, Mesh, Quaternion, Sphere,
        Vector3} from 'three';
import {acceleratedRaycast, MeshBVH} from 'three-mesh-bvh';

import {detailMaterial, hatching, known_kinds, proposedMaterial, setOpacity, setSide, shade} from './colours.js';
import {boxOf, fragmentsOf} from './fragments.js';
import {Frame} from './frame.js';
import {readGlb} from './glb.js';
import {Items} from './items.js';
import {edgesOf} from './polygons.js';
import {surfacesOf} from './surfaces.js';
import {Textures} from './textures.js';

Mesh.prototype.raycast = acceleratedRaycast;

const outline_material = new LineBasicMaterial({color: 0x44505e, transparent: true, opacity: 0.55});

function lines(loops, material) {
  return new LineSegments(new BufferGeometry().setFromPoints(edgesOf(loops)), material);
}

function wayOf(places, colour) {
  return new Line(new BufferGeometry().setFromPoints(places), new LineBasicMaterial({color: colour}));
}

// A node of map.glb in the frame of the scene.
function placed(node, frame, material) {
  const group = new Group();
  const to_scene = frame.of_glb.clone().multiply(node.matrix);
  for (const {geometry} of node.parts) {
    geometry.applyMatrix4(to_scene);
    group.add(new Mesh(geometry, material));
  }
  return group;
}

const no_node = {rotation: new Quaternion(), translation: new Vector3(), matrix: new Matrix4(), parts: []};

export class World {
  // What can be shown at once; finish() unpacks the rest.
  static async load(data, renderer) {
    const world = new World();
    const glb = readGlb(data.glb);
    const node = glb.node('map') ?? no_node;
    world.map = data.map;
    world.has_colours = data.has_colours;
    world.frame = new Frame(data.map, node);
    world.textures = new Textures(glb, data, renderer);
    const unpacked = Promise.all(node.parts.map(part => part.image !== null && world.textures.page(part)));
    world.items = new Items(data.map, world.frame); // while images are unpacked
    world.fragments = fragmentsOf(data.map, world.items.planes);
    await unpacked;
    world.surfaces = await surfacesOf(data, node, world.frame, world.textures);
    world.group = new Group();
    world.addSurfaces();
    world.addLayers(data, name => glb.node(name));
    world.measureExtent();
    if (!world.textures.hasPreviews)
      await world.finish();
    return world;
  }

  async finish() {
    await this.textures.finish();
    known_kinds.value = true;
  }

  addSurfaces() {
    this.surfaces_of = new Map();
    for (const surface of this.surfaces) {
      surface.item = this.items.find(surface.kind, surface.id);
      surface.is_fragment = surface.kind === 'plane' && this.fragments.has(surface.id);
      surface.meshes = [...surface.group.children];
      if (surface.item)
        this.surfaces_of.set(surface.item, [...(this.surfaces_of.get(surface.item) ?? []), surface]);
      this.group.add(surface.group);
    }
  }

  addLayers(data, node) {
    const add = (name, object) => {
      this[name] = object;
      if (object)
        this.group.add(object);
    };
    const proposed = node('proposed'), details = node('details');
    add('proposed', proposed && placed(proposed, this.frame, proposedMaterial()));
    add('details', details && placed(details, this.frame, detailMaterial()));
    if (!data.has_colours)
      for (const {geometry} of this.details?.children ?? []) {
        geometry.computeVertexNormals();
        shade(geometry, 'other');
      }
    const way = (data.map.trajectory ?? []).map(pose => this.frame.place(pose.position));
    add('way', way.length > 1 ? wayOf(way, 0x1463c2) : null);
    add('before', data.before.length > 1 ? wayOf(data.before.map(p => this.frame.place(p)), 0xd9542b) : null);
    this.has_unseen = Boolean(proposed) || this.surfaces.some(surface => surface.is_unseen);
  }

  measureExtent() {
    const shown = this.items.planes.filter(item => !this.fragments.has(item.id));
    const items = [...shown, ...this.items.cylinders];
    this.box = boxOf(items);
    this.places = [...items.flatMap(item => item.corners.flat()), ...this.placesOfDetails()];
    for (const place of this.places)
      this.box.expandByPoint(place);
    if (this.places.length === 0)
      this.places = [this.box.min, this.box.max];
    this.center = this.box.getCenter(new Vector3());
    this.radius = Math.max(0.5, this.box.getBoundingSphere(new Sphere()).radius);
  }

  // Some of their corners, as far as they are next to what they belong to.
  placesOfDetails() {
    const near = this.box.clone().expandByScalar(0.3);
    const places = [];
    for (const {geometry: {attributes: {position}}} of this.details?.children ?? [])
      for (let i = 0; i < position.count; i += Math.ceil(position.count / 2000))
        places.push(new Vector3().fromBufferAttribute(position, i));
    return places.filter(place => near.containsPoint(place));
  }

  // Shows what layers and the view leave of each surface.
  update(layers, view) {
    hatching.value = layers.unseen;
    const both = layers.behind || view.name === 'inside';
    for (const surface of this.surfaces) {
      const opacity = both || surface.kind !== 'plane' ? 1 : view.opacityOf(surface.item);
      surface.group.visible = layers.surfaces && opacity > 0 && (layers.fragments || !surface.is_fragment);
      if (!surface.group.visible)
        continue;
      for (const mesh of surface.meshes) {
        mesh.material = opacity < 1 ? mesh.userData.fading() : mesh.userData.whole;
        setSide(mesh.material, both);
        if (opacity < 1)
          setOpacity(mesh.material, opacity);
      }
      this.showOutline(surface, layers.outlines && opacity > 0.5);
    }
    for (const name of ['details', 'way', 'before'])
      if (this[name])
        this[name].visible = layers[name];
    if (this.proposed)
      this.proposed.visible = layers.unseen;
    for (const part of [...(this.details?.children ?? []), ...(this.proposed?.children ?? [])])
      setSide(part.material, both);
  }

  showOutline(surface, is_shown) {
    if (is_shown && !surface.outline && surface.item)
      surface.group.add(surface.outline = lines(surface.item.corners, outline_material));
    if (surface.outline)
      surface.outline.visible = is_shown;
  }

  isShown(item) {
    const surfaces = this.surfaces_of.get(item) ?? [];
    return surfaces.length === 0 || surfaces.some(surface => surface.group.visible);
  }

  // Meshes of surfaces that a test of their items accepts, ready for rays.
  meshesOf(accepts) {
    const meshes = this.surfaces.filter(surface => surface.item && accepts(surface.item)).flatMap(s => s.meshes);
    for (const mesh of meshes)
      mesh.geometry.boundsTree ??= new MeshBVH(mesh.geometry);
    return meshes;
  }

  // What a ray meets first: {point, distance, item}, whose item is null for details; or null.
  hit(ray) {
    ray.firstHitOnly = true;
    const meshes = this.meshesOf(item => this.isShown(item));
    const details = this.details?.visible ? this.details.children : [];
    for (const mesh of details)
      mesh.geometry.boundsTree ??= new MeshBVH(mesh.geometry);
    const first = ray.intersectObjects([...meshes, ...details], false)[0];
    return first ? {point: first.point, distance: first.distance,
                    item: first.object.userData.surface?.item ?? null} : null;
  }
}
