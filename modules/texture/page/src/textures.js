// The images of the page as textures. Those of large maps take a while to unpack: a small
// picture of them is shown until then.

import {LinearFilter, LinearMipmapLinearFilter, NearestFilter, NoColorSpace, SRGBColorSpace, Texture}
  from 'three';

function colourTexture(renderer) {
  const texture = new Texture();
  texture.flipY = false;
  texture.colorSpace = SRGBColorSpace;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.magFilter = LinearFilter;
  texture.anisotropy = Math.min(16, renderer.capabilities.getMaxAnisotropy());
  return texture;
}

// Numbers of kinds are no colours.
function kindTexture() {
  const texture = new Texture();
  texture.flipY = false;
  texture.colorSpace = NoColorSpace;
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.generateMipmaps = false;
  return texture;
}

async function setImage(texture, file, options = {}) {
  let image;
  try {
    image = await createImageBitmap(file, {premultiplyAlpha: 'none', ...options});
  } catch {
    throw new Error('an image in this page is damaged');
  }
  texture.dispose();
  texture.image = image;
  texture.needsUpdate = true;
}

const png = bytes => new Blob([bytes], {type: 'image/png'});

// Columns and rows of a PNG, from its head.
function sizeOfPng(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  return bytes.length < 24 ? [1, 1] : [view.getUint32(16), view.getUint32(20)];
}

export const numberIn = name => Number(/\d+/.exec(name ?? '')?.[0] ?? -1);

export class Textures {
  constructor(glb, data, renderer) {
    Object.assign(this, {glb, data, renderer});
    this.previews = new Map(Object.entries(data.previews).map(([name, preview]) => [numberIn(name), preview]));
    this.pages = new Map();
    this.kinds = new Map();
    this.later = []; // functions that make textures whole
    this.unpacking = [];
    for (const [name, bytes] of Object.entries(data.kinds))
      this.addKinds(name, bytes);
  }

  // Is a small picture shown before the whole one?
  get hasPreviews() { return this.previews.size > 0; }

  addKinds(name, bytes) {
    const texture = kindTexture();
    this.kinds.set(name, {texture, size: sizeOfPng(bytes)});
    const unpack = () => setImage(texture, png(bytes), {colorSpaceConversion: 'none'});
    if (this.hasPreviews)
      this.later.push(unpack);
    else
      this.unpacking.push(unpack());
  }

  // The texture of a page, once there is something of it to be seen, and the size of the page.
  // part: of map.glb that has it
  page({material, image}) {
    if (!this.pages.has(material))
      this.pages.set(material, this.unpackedPage(this.previews.get(numberIn(material)), this.glb.image(image)));
    return this.pages.get(material);
  }

  async unpackedPage(preview, file) {
    const texture = colourTexture(this.renderer);
    await setImage(texture, preview ? new Blob([preview.jpeg], {type: 'image/jpeg'}) : file);
    if (preview)
      this.later.push(() => setImage(texture, file));
    return {texture, size: preview?.size ?? [texture.image.width, texture.image.height]};
  }

  async finish() { await Promise.all([...this.unpacking, ...this.later.splice(0).map(unpack => unpack())]); }
}
