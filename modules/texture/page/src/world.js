// All that is drawn, and what the views, cards and measures ask about it.

import {BufferGeometry, Group, Line, LineBasicMaterial, LineSegments, Mesh, Sphere, Vector3} from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';
import {acceleratedRaycast, MeshBVH} from 'three-mesh-bvh';

import {detailMaterial, hatching, proposedMaterial, setOpacity, setSide} from './colours.js';
import {boxOf, fragmentsOf} from './fragments.js';
import {Frame} from './frame.js';
import {Items} from './items.js';
import {surfacesOf} from './surfaces.js';

Mesh.prototype.raycast = acceleratedRaycast;

function lines(loops, material) {
  const points = loops.flatMap(loop => loop.flatMap((p, i) => [p, loop[(i + 1) % loop.length]]));
  return new LineSegments(new BufferGeometry().setFromPoints(points), material);
}

function wayOf(places, colour) {
  return new Line(new BufferGeometry().setFromPoints(places), new LineBasicMaterial({color: colour}));
}

// A mesh of map.glb in the frame of the scene.
function placed(node, frame, material) {
  const group = new Group();
  node.traverse(part => {
    if (!part.isMesh)
      return;
    const geometry = part.geometry.clone().applyMatrix4(part.matrixWorld).applyMatrix4(frame.of_glb);
    if (!geometry.attributes.normal)
      geometry.computeVertexNormals();
    group.add(new Mesh(geometry, material));
  });
  return group;
}

async function nodesOf(glb) {
  let gltf;
  try {
    gltf = await new GLTFLoader().parseAsync(glb.buffer, '');
  } catch (error) {
    throw new Error(`the surfaces in this page are damaged: ${error.message ?? error}`);
  }
  gltf.scene.updateMatrixWorld(true);
  return name => gltf.scene.children.find(node => node.name === name) ?? null;
}

export class World {
  static async load(data, renderer) {
    const world = new World();
    const node = await nodesOf(data.glb);
    const surfaces_node = node('map') ?? new Group();
    world.map = data.map;
    world.frame = new Frame(data.map, surfaces_node);
    world.items = new Items(data.map, world.frame);
    world.fragments = fragmentsOf(data.map, world.items.planes);
    world.surfaces = await surfacesOf(data, surfaces_node, world.frame, renderer);
    world.group = new Group();
    world.addSurfaces();
    world.addLayers(data, node);
    world.measureExtent();
    return world;
  }

  addSurfaces() {
    const outline = new LineBasicMaterial({color: 0x44505e, transparent: true, opacity: 0.55});
    for (const surface of this.surfaces) {
      surface.item = this.items.find(surface.kind, surface.id);
      surface.is_fragment = surface.kind === 'plane' && this.fragments.has(surface.id);
      surface.meshes = [...surface.group.children];
      if (surface.item) {
        surface.outline = lines(surface.item.corners, outline);
        surface.group.add(surface.outline);
      }
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
    const way = (data.map.trajectory ?? []).map(pose => this.frame.place(pose.position));
    add('way', way.length > 1 ? wayOf(way, 0x1463c2) : null);
    add('before', data.before.length > 1 ? wayOf(data.before.map(p => this.frame.place(p)), 0xd9542b) : null);
    this.has_unseen = Boolean(proposed) || this.surfaces.some(surface => surface.is_unseen);
  }

  measureExtent() {
    const shown = this.items.planes.filter(item => !this.fragments.has(item.id));
    const items = [...shown, ...this.items.cylinders];
    this.box = boxOf(items);
    this.places = items.flatMap(item => item.corners.flat());
    if (this.places.length === 0)
      this.places = [this.box.min, this.box.max];
    this.center = this.box.getCenter(new Vector3());
    this.radius = Math.max(0.5, this.box.getBoundingSphere(new Sphere()).radius);
  }

  // Shows what layers and the view leave of each surface.
  update(layers, view) {
    hatching.value = layers.unseen;
    const both = layers.behind || view.name === 'inside';
    for (const surface of this.surfaces) {
      const opacity = both || surface.kind !== 'plane' ? 1 : view.opacityOf(surface.item);
      surface.group.visible = layers.surfaces && opacity > 0 && (layers.fragments || !surface.is_fragment);
      for (const mesh of surface.meshes) {
        setSide(mesh.material, both);
        setOpacity(mesh.material, opacity);
      }
      if (surface.outline)
        surface.outline.visible = layers.outlines && opacity > 0.5;
    }
    for (const name of ['details', 'way', 'before'])
      if (this[name])
        this[name].visible = layers[name];
    if (this.proposed)
      this.proposed.visible = layers.unseen;
    for (const part of [...(this.details?.children ?? []), ...(this.proposed?.children ?? [])])
      setSide(part.material, both);
  }

  isShown(item) {
    const surfaces = this.surfaces.filter(surface => surface.item === item);
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
