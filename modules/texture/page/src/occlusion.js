// Ambient occlusion, which is added to a picture once the camera rests.

import {FullScreenQuad} from 'three/addons/postprocessing/Pass.js';
import {GTAOPass} from 'three/addons/postprocessing/GTAOPass.js';

const strength = 0.75;
const radius = 0.45; // metres of the places that take light from each other
const fading = 200;  // milliseconds in which it appears

export class Occlusion {
  constructor(picture, world) {
    this.picture = picture;
    this.world = world;
    this.pass = null;
    this.is_on = true;
  }

  prepare(view) {
    const {renderer, scene} = this.picture;
    const ratio = Math.min(1.5, renderer.getPixelRatio());
    const [width, height] = [window.innerWidth * ratio, window.innerHeight * ratio].map(Math.round);
    if (!this.pass) {
      this.pass = new GTAOPass(scene, view.camera, width, height);
      this.pass.output = GTAOPass.OUTPUT.Off;
      this.pass.updateGtaoMaterial({radius, distanceExponent: 1, thickness: 0.6, scale: 1, samples: 12,
                                    distanceFallOff: 1, screenSpaceRadius: false});
      this.pass.updatePdMaterial({lumaPhi: 10, depthPhi: 2, normalPhi: 3, radius: 5, rings: 2, samples: 12});
      this.quad = new FullScreenQuad(this.pass.blendMaterial);
    }
    this.pass.camera = view.camera;
    if (this.pass.width !== width || this.pass.height !== height)
      this.pass.setSize(width, height);
  }

  // What it asks of all that is drawn.
  giveNormals() {
    this.picture.scene.traverse(({isMesh, geometry}) => {
      if (isMesh && geometry.attributes.position && !geometry.attributes.normal)
        geometry.computeVertexNormals();
    });
  }

  // Faces that fade away take no light from others.
  withoutFaded(draw) {
    const hidden = [];
    this.picture.scene.traverse(object => {
      if (object.isMesh && object.visible && object.material.transparent) {
        object.visible = false;
        hidden.push(object);
      }
    });
    draw();
    for (const object of hidden)
      object.visible = true;
  }

  add(view) {
    document.body.dataset.occlusion = 'none';
    if (!this.is_on || !view.camera.isPerspectiveCamera)
      return;
    const {renderer} = this.picture;
    this.prepare(view);
    this.giveNormals();
    this.withoutFaded(() => this.pass.render(renderer));
    renderer.setRenderTarget(null);
    const begun = performance.now();
    const show = () => {
      const share = Math.min(1, (performance.now() - begun) / fading);
      this.picture.render();
      this.pass.blendMaterial.uniforms.intensity.value = strength * share;
      this.pass.blendMaterial.uniforms.tDiffuse.value = this.pass.gtaoMap;
      renderer.autoClear = false;
      this.quad.render(renderer);
      renderer.autoClear = true;
      if (share < 1)
        this.picture.later = requestAnimationFrame(show);
      else
        document.body.dataset.occlusion = 'shown';
    };
    show();
  }
}
