// Draws the scene when something has changed, and not otherwise.

import {Color, Scene, SRGBColorSpace, NoToneMapping, Timer, WebGLRenderer} from 'three';

import {setPixelRatio} from './colours.js';

const background = 0xe9eef3;

export class Picture {
  // \throws when the browser has no WebGL
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({canvas, antialias: true});
    this.renderer.outputColorSpace = SRGBColorSpace;
    this.renderer.toneMapping = NoToneMapping;
    this.renderer.setClearColor(new Color(background));
    this.scene = new Scene();
    this.timer = new Timer();
    this.view = null;
    this.before = [];  // called before each picture
    this.after = () => {}; // called once the camera rests
    this.is_waiting = false;
    this.rests = 0; // timer of the rest
    this.later = 0; // frame of what appears then
  }

  // Asks for a new picture; the occlusion of the last one is old then.
  change() {
    clearTimeout(this.rests);
    cancelAnimationFrame(this.later);
    document.body.dataset.camera = 'moves';
    if (this.is_waiting)
      return;
    this.is_waiting = true;
    requestAnimationFrame(time => this.draw(time));
  }

  draw(time) {
    this.is_waiting = false;
    this.timer.update(time);
    const moves = this.view.controls.update(Math.min(this.timer.getDelta(), 0.1));
    this.render();
    if (moves)
      this.change();
    else
      this.rests = setTimeout(() => this.rest(), 120);
  }

  rest() {
    this.after();
    document.body.dataset.camera = 'rests';
  }

  render() {
    for (const prepare of this.before)
      prepare();
    this.renderer.render(this.scene, this.view.camera);
  }

  resize() {
    const width = Math.max(1, window.innerWidth), height = Math.max(1, window.innerHeight);
    const ratio = Math.min(window.devicePixelRatio || 1, 3);
    setPixelRatio(ratio);
    if (ratio !== this.renderer.getPixelRatio()) // else the picture is made twice
      this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    return [width, height];
  }
}
