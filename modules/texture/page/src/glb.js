// Reads map.glb: its nodes, their meshes, and its images as they are stored. All is in one
// buffer, as acmap writes it, without extensions.

import {BufferAttribute, BufferGeometry, Matrix4, Quaternion, Vector3} from 'three';

const magic = 0x46546c67, json_chunk = 0x4e4f534a;
const arrays = {5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array};
const components = {SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4};
const names = {POSITION: 'position', NORMAL: 'normal', TEXCOORD_0: 'uv', COLOR_0: 'color'};

class Glb {
  constructor(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    if (view.getUint32(0, true) !== magic || view.getUint32(16, true) !== json_chunk)
      throw new Error('they are no GLB');
    const length = view.getUint32(12, true);
    this.json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length)));
    this.buffer = bytes.subarray(28 + length);
  }

  // The bytes of a part of the buffer.
  view(number) {
    const {byteOffset = 0, byteLength} = this.json.bufferViews[number];
    if (byteOffset + byteLength > this.buffer.length)
      throw new Error('they end too early');
    return this.buffer.subarray(byteOffset, byteOffset + byteLength);
  }

  // Values of an accessor, which follow each other without gaps.
  attribute(number) {
    const {bufferView, byteOffset = 0, componentType, type, count, normalized} = this.json.accessors[number];
    const Values = arrays[componentType], size = components[type];
    const bytes = this.view(bufferView).slice(byteOffset, byteOffset + count * size * Values.BYTES_PER_ELEMENT);
    return new BufferAttribute(new Values(bytes.buffer), size, normalized);
  }

  geometry(primitive) {
    const geometry = new BufferGeometry();
    for (const [name, accessor] of Object.entries(primitive.attributes))
      if (names[name])
        geometry.setAttribute(names[name], this.attribute(accessor));
    if (primitive.indices !== undefined)
      geometry.setIndex(this.attribute(primitive.indices));
    return geometry;
  }

  // {rotation, translation, matrix, parts: [{geometry, material: name, image: number or null}]}
  node(name) {
    const node = this.json.nodes?.find(candidate => candidate.name === name);
    if (!node)
      return null;
    const rotation = new Quaternion(...(node.rotation ?? [0, 0, 0, 1]));
    const translation = new Vector3(...(node.translation ?? [0, 0, 0]));
    const scale = new Vector3(...(node.scale ?? [1, 1, 1]));
    const parts = (this.json.meshes?.[node.mesh]?.primitives ?? []).map(primitive => {
      const material = this.json.materials?.[primitive.material];
      const texture = material?.emissiveTexture ?? material?.pbrMetallicRoughness?.baseColorTexture;
      return {geometry: this.geometry(primitive), material: material?.name ?? '',
              image: texture ? this.json.textures[texture.index].source : null};
    });
    return {rotation, translation, parts, matrix: new Matrix4().compose(translation, rotation, scale)};
  }

  // An image as a file.
  image(number) {
    const {bufferView, mimeType} = this.json.images[number];
    return new Blob([this.view(bufferView)], {type: mimeType});
  }
}

// \throws Error with what is wrong with the bytes
export function readGlb(bytes) {
  try {
    return new Glb(bytes);
  } catch (error) {
    throw new Error(`the surfaces in this page are damaged: ${error.message}`);
  }
}
