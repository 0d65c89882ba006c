// Materials: colours as they are in the texture, without any light, and hatching where nobody
// looked.

import {BufferAttribute, Color, DoubleSide, FrontSide, MeshBasicMaterial, Vector3} from 'three';

// Shared by all materials: is what nobody saw hatched, or left out?
export const hatching = {value: true};
// Are the kinds of the texels unpacked?
export const known_kinds = {value: false};
const pixel = {value: 1}; // of the screen, in pixels of the picture

export function setPixelRatio(ratio) { pixel.value = ratio; }

// Thin lines over a light ground, the same on the screen at any distance.
const hatch = `
vec4 acmapHatch (vec3 line) {
  float at = mod(gl_FragCoord.x + gl_FragCoord.y, 9.0 * pixel) / pixel;
  float share = smoothstep(0.0, 0.7, at) * (1.0 - smoothstep(1.2, 1.9, at));
  return vec4(mix(vec3(0.86, 0.88, 0.91), line, share), 1.0);
}`;

function hatchWhere(material, line, condition, attributes) {
  material.onBeforeCompile = shader => {
    Object.assign(shader.uniforms, {hatched: hatching, pixel}, attributes.uniforms);
    shader.vertexShader = shader.vertexShader
      .replace('void main() {', `${attributes.vertex}\nvoid main() {\n${attributes.main}`);
    shader.fragmentShader = shader.fragmentShader
      .replace('void main() {',
               `uniform bool hatched;\nuniform float pixel;\n${attributes.fragment}\n${hatch}\nvoid main() {`)
      .replace('#include <map_fragment>', `#include <map_fragment>
        if (${condition}) {
          if (!hatched) discard;
          diffuseColor.rgb = acmapHatch(${line}).rgb;
        }`);
  };
  material.customProgramCacheKey = () => condition + line;
  return material;
}

const unseen_line = 'vec3(0.36, 0.42, 0.50)', proposed_line = 'vec3(0.16, 0.40, 0.72)';

// The colours of a page of the atlas; kinds: the texture of the kinds of its texels.
export function textureMaterial(map, kinds) {
  const material = new MeshBasicMaterial({map, side: FrontSide, toneMapped: false});
  if (!kinds)
    return material;
  return hatchWhere(material, unseen_line, 'has_kinds && vKind.x >= 0.0 && texture2D(kinds, vKind).r < 0.002', {
    uniforms: {kinds: {value: kinds}, has_kinds: known_kinds},
    vertex: 'attribute vec2 kind;\nvarying vec2 vKind;',
    main: 'vKind = kind;',
    fragment: 'uniform sampler2D kinds;\nuniform bool has_kinds;\nvarying vec2 vKind;'
  });
}

const nothing = {uniforms: {}, vertex: '', main: '', fragment: ''};

// A surface of which nobody saw a colour.
export const unseenMaterial = () =>
  hatchWhere(new MeshBasicMaterial({side: FrontSide, toneMapped: false}), unseen_line, 'true', nothing);

// One that nobody saw, but which must be there.
export const proposedMaterial = () =>
  hatchWhere(new MeshBasicMaterial({side: FrontSide, toneMapped: false}), proposed_line, 'true', nothing);

// Of what was seen without colours, by role.
const plain = {floor: 0xb3a996, ceiling: 0xe6e8ea, wall: 0xd4dae1, 'door leaf': 0xb98f66, furniture: 0x8fb0cf};
const light = new Vector3(0.35, 0.8, 0.5).normalize(), shadow = 0.62;

// Gives a geometry with normals the colour of its role, brighter where it faces the light.
export function shade(geometry, role) {
  const color = new Color(plain[role] ?? 0xc3c8cd), normal = new Vector3();
  const {position, normal: normals} = geometry.attributes;
  const colors = new Float32Array(3 * position.count);
  for (let i = 0; i < position.count; ++i) {
    const facing = 0.5 + 0.5 * normal.fromBufferAttribute(normals, i).dot(light);
    color.clone().multiplyScalar(shadow + (1 - shadow) * facing).toArray(colors, 3 * i);
  }
  geometry.setAttribute('color', new BufferAttribute(colors, 3));
}

export const detailMaterial = () =>
  new MeshBasicMaterial({vertexColors: true, side: FrontSide, toneMapped: false});

export function setSide(material, seen_from_behind) {
  material.side = seen_from_behind ? DoubleSide : FrontSide;
}

// How much of a face is left, between 0 and 1.
export function setOpacity(material, opacity) {
  material.opacity = opacity;
  material.transparent = true;
  material.depthWrite = false;
}
