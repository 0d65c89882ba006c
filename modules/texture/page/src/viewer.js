// The page: its views and tools, and what clicks, keys and buttons do.

import {Raycaster, Vector2} from 'three';

import {Card} from './card.js';
import {Dollhouse} from './dollhouse.js';
import {FloorRing} from './floor_ring.js';
import {Inside} from './inside.js';
import {listenToKeys} from './keys.js';
import {Labels} from './labels.js';
import {Layers} from './layers.js';
import {followLink, writeLink} from './link.js';
import {List} from './list.js';
import {Measuring} from './measuring.js';
import {Occlusion} from './occlusion.js';
import {Plan} from './plan.js';
import {listenToPointer} from './pointer.js';

const byId = id => document.getElementById(id);

export class Viewer {
  constructor(world, picture) {
    this.world = world;
    this.picture = picture;
    this.ray = new Raycaster();
    this.layers = new Layers(world, () => this.changed());
    this.labels = new Labels();
    this.views = {dollhouse: new Dollhouse(world, picture.canvas), inside: new Inside(world, picture.canvas),
                  plan: new Plan(world, picture.canvas)};
    this.card = new Card(picture.scene, () => this.choose(null));
    this.ring = new FloorRing(picture.scene);
    this.list = new List(world.items, world.fragments, item => this.goTo(item));
    this.measuring = new Measuring(world, picture.scene, this.labels, () => this.changed());
    this.occlusion = new Occlusion(picture, world);
    picture.scene.add(world.group, this.views.plan.walls.group);
    picture.before.push(() => this.prepare());
    picture.after = () => this.rest();
    this.visited = new Set();
    this.nameRooms();
  }

  start() {
    for (const id of ['views', 'corner', 'side'])
      byId(id).hidden = false;
    this.resize();
    this.listen();
    this.measuring.set(false);
    followLink(this);
    this.changed();
  }

  // --- views

  get view() { return this.picture.view; }

  enter(name) {
    const view = this.views[name];
    for (const other of Object.values(this.views))
      other.controls.enabled = false;
    view.controls.enabled = true;
    for (const id of Object.keys(this.views))
      byId(id).setAttribute('aria-pressed', String(id === name));
    this.picture.view = view;
    this.views.plan.walls.group.visible = name === 'plan';
    this.ring.hide();
    view.controls.stop();
    if (!this.visited.has(name)) {
      this.visited.add(name);
      view.home(false);
    }
    document.body.dataset.view = name;
    byId('hint').textContent = view.hint;
    this.changed();
  }

  resize() {
    const [width, height] = this.picture.resize();
    for (const view of Object.values(this.views))
      view.resize(width, height);
  }

  prepare() {
    const {view, world} = this;
    view.setClipping();
    view.camera.updateMatrixWorld();
    world.update(this.layers, view);
    this.labels.follow(view.camera);
    this.measuring.face(view);
    if (this.card.mark)
      this.card.mark.visible = this.card.item.kind === 'room' || world.isShown(this.card.item);
  }

  // A face that turned away takes its card along.
  rest() {
    const {item} = this.card;
    if (item && item.kind === 'plane' && !this.world.isShown(item))
      this.choose(null);
    writeLink(this);
    this.occlusion.add(this.view);
  }

  changed() { this.picture.change(); }

  // --- what is chosen

  choose(item) {
    this.card.show(item);
    this.list.mark(item);
    this.changed();
  }

  // Shows a layer that hides it, and flies to it.
  goTo(item) {
    this.reveal(item);
    this.choose(item);
    this.view.show(item);
    document.body.classList.remove('contents');
    this.changed();
  }

  reveal(item) {
    this.layers.set('surfaces', true);
    if (item.kind === 'plane' && this.world.fragments.has(item.id))
      this.layers.set('fragments', true);
  }

  hitAt({x, y}) {
    const place = new Vector2(2 * x / window.innerWidth - 1, 1 - 2 * y / window.innerHeight);
    this.ray.setFromCamera(place, this.view.camera);
    return this.world.hit(this.ray);
  }

  // Is it a floor to walk on?
  isFloor(hit) {
    return this.view.name === 'inside' && !this.measuring.is_on && hit?.item?.normal?.y > 0.9 &&
           hit.item.role !== 'furniture';
  }

  clicked(pointer, kind) {
    document.body.classList.remove('contents');
    const hit = this.hitAt(pointer);
    if (this.measuring.is_on)
      this.measuring.pick(this.measuring.candidate(pointer, this.view, this.ray, hit, kind));
    else if (this.isFloor(hit))
      this.view.walkTo(hit.point);
    else
      this.choose(hit?.item ?? null);
    this.changed();
  }

  hovered(pointer, kind) {
    if (!this.measuring.is_on && this.view.name !== 'inside')
      return;
    const hit = this.hitAt(pointer);
    if (this.measuring.is_on)
      this.measuring.hover(this.measuring.candidate(pointer, this.view, this.ray, hit, kind), this.view);
    else if (!this.ring.follow(this.isFloor(hit) ? hit.point : null))
      return;
    this.changed();
  }

  nameRooms() {
    this.labels.set('room', this.world.items.rooms.map(room => ({
      place: room.place, text: room.name,
      isShown: () => this.layers.names && this.view.name !== 'inside'})));
  }

  // --- keys and buttons

  close() {
    if (!byId('help_text').hidden)
      byId('help_text').hidden = true;
    else if (document.body.classList.contains('contents'))
      document.body.classList.remove('contents');
    else if (this.measuring.is_on && this.measuring.clear())
      this.measuring.set(false);
    else if (!this.measuring.is_on)
      this.choose(null);
    this.changed();
  }

  home() {
    this.view.home(true);
    this.changed();
  }

  toggleMeasuring() {
    this.measuring.set(!this.measuring.is_on);
    this.ring.hide();
  }

  step(forward, aside) {
    if (this.view.name === 'inside')
      this.view.step(forward, aside);
    this.changed();
  }

  listen() {
    const toggleHelp = () => { byId('help_text').hidden = !byId('help_text').hidden; };
    for (const name of Object.keys(this.views))
      byId(name).addEventListener('click', () => this.enter(name));
    byId('measure').addEventListener('click', () => this.toggleMeasuring());
    byId('home').addEventListener('click', () => this.home());
    byId('help').addEventListener('click', toggleHelp);
    byId('help_text').querySelector('.close').addEventListener('click', toggleHelp);
    byId('contents').addEventListener('click', () => document.body.classList.toggle('contents'));
    listenToKeys({1: () => this.enter('dollhouse'), 2: () => this.enter('inside'), 3: () => this.enter('plan'),
                  m: () => this.toggleMeasuring(), h: () => this.home(), '?': toggleHelp,
                  Escape: () => this.close(),
                  ArrowUp: () => this.step(1, 0), ArrowDown: () => this.step(-1, 0),
                  ArrowLeft: () => this.step(0, -1), ArrowRight: () => this.step(0, 1)});
    listenToPointer(this.picture.canvas, {clicked: (...at) => this.clicked(...at),
                                          hovered: (...at) => this.hovered(...at)});
    for (const view of Object.values(this.views))
      for (const event of ['control', 'wake'])
        view.controls.addEventListener(event, () => this.changed());
    addEventListener('resize', () => {
      this.resize();
      this.changed();
    });
    addEventListener('hashchange', () => followLink(this));
  }
}
