// The tool that measures: two picks make a distance. It works in all views.

import {Mesh, MeshBasicMaterial, RingGeometry, SphereGeometry} from 'three';

import {thickLines} from './card.js';
import {betweenPlanes, betweenPoints} from './distances.js';
import {edgesOf} from './polygons.js';
import {Snapping} from './snapping.js';

const byId = id => document.getElementById(id);
const colour = 0xc2185b;

export class Measuring {
  // changed: called when the picture or the link is another one
  constructor(world, scene, labels, changed) {
    Object.assign(this, {world, scene, labels, changed});
    this.snapping = new Snapping(world);
    this.is_on = false;
    this.between = 'points';
    this.picks = [];
    this.result = null;
    this.drawn = [];
    this.cursor = new Mesh(new SphereGeometry(1, 16, 12), material());
    this.cursor.renderOrder = 3;
    this.cursor.raycast = () => {};
    this.cursor.visible = false;
    scene.add(this.cursor);
    for (const between of ['points', 'planes'])
      byId(between).addEventListener('click', () => this.measureBetween(between));
    byId('measuring').querySelector('.close').addEventListener('click', () => this.set(false));
  }

  set(is_on) {
    this.is_on = is_on;
    byId('measuring').hidden = !is_on;
    byId('measure').setAttribute('aria-pressed', String(is_on));
    this.cursor.visible = false;
    this.clear();
  }

  measureBetween(between) {
    this.between = between;
    this.clear();
  }

  // Forgets the picks; is there nothing to forget?
  clear() {
    const had_none = this.picks.length === 0;
    this.picks = [];
    this.result = null;
    this.redraw();
    return had_none;
  }

  // What a click would pick there.
  candidate(pointer, view, ray, hit, kind) {
    if (this.between === 'planes')
      return hit?.item?.normal && hit.item.kind === 'plane' ? {point: hit.point, item: hit.item, snap: null} : null;
    const found = this.snapping.at(pointer, view, ray, hit, kind);
    if (found && view.name === 'plan') // where distances are level
      found.point = found.point.clone().setY(this.world.box.min.y);
    return found;
  }

  hover(candidate, view) {
    this.cursor.visible = Boolean(candidate) && this.between === 'points';
    if (candidate) {
      this.cursor.position.copy(candidate.point);
      this.cursor.material.color.set(candidate.snap ? colour : 0x5d6b7c);
      this.cursor.scale.setScalar(sizeAt(candidate.point, view) * (candidate.snap === 'corner' ? 6 : 4.5));
    }
  }

  pick(candidate) {
    if (!candidate)
      return;
    if (this.picks.length === 2)
      this.picks = [];
    this.picks.push(candidate);
    this.finish();
  }

  finish() {
    const [first, second] = this.picks;
    this.result = !second ? null
      : this.between === 'points' ? betweenPoints(first, second) : betweenPlanes(first, second);
    this.redraw();
  }

  told() {
    if (this.result?.refused)
      return this.result.refused;
    if (this.result)
      return `${this.result.text} (${this.result.more})`;
    const what = this.between === 'points' ? 'point' : 'surface';
    return this.picks.length === 0 ? `click on a ${what}` : `click on a second ${what}`;
  }

  redraw() {
    for (const object of this.drawn)
      this.scene.remove(object);
    this.drawn = [];
    const add = object => {
      this.scene.add(object);
      this.drawn.push(object);
    };
    for (const {item} of this.between === 'planes' ? this.picks : [])
      add(thickLines(edgesOf(item.loops), colour, 2));
    const ends = this.result?.ends ?? (this.between === 'points' ? this.picks.map(pick => pick.point) : []);
    this.dots = ends.map(point => {
      const dot = new Mesh(new RingGeometry(0.45, 1, 24), material());
      dot.position.copy(point);
      dot.renderOrder = 3;
      dot.raycast = () => {};
      add(dot);
      return dot;
    });
    if (this.result?.ends)
      add(thickLines(this.result.ends, colour, 3));
    this.labels.set('distance', this.result?.ends
      ? [{place: ends[0].clone().lerp(ends[1], 0.5), text: this.result.text}] : []);
    byId('told').textContent = this.told();
    for (const between of ['points', 'planes'])
      byId(between).setAttribute('aria-pressed', String(this.between === between));
    this.changed();
  }

  // Dots keep their size on the screen, and face the camera.
  face(view) {
    for (const dot of this.dots ?? []) {
      dot.quaternion.copy(view.camera.quaternion);
      dot.scale.setScalar(6 * sizeAt(dot.position, view));
    }
  }

  // As a part of a link, in the frame of the map; and back.
  link() {
    if (this.picks.length < 2)
      return null;
    return this.between === 'planes' ? this.picks.map(pick => pick.item.id).join(',')
      : this.picks.flatMap(pick => this.world.frame.placeInMap(pick.point).map(x => x.toFixed(3))).join(',');
  }

  follow(between, numbers) {
    this.set(true);
    this.between = between;
    this.picks = between === 'planes'
      ? numbers.slice(0, 2).map(id => this.world.items.planes[id]).filter(item => item)
        .map(item => ({point: item.place, item, snap: null}))
      : numbers.length === 6
        ? [0, 3].map(i => ({point: this.world.frame.place(numbers.slice(i, i + 3)), item: null, snap: null})) : [];
    this.finish();
  }
}

const material = () =>
  new MeshBasicMaterial({color: colour, depthTest: false, transparent: true, toneMapped: false});

// Metres that a pixel has at a place.
function sizeAt(place, view) {
  const {camera} = view;
  if (camera.isOrthographicCamera)
    return 1 / camera.zoom;
  const depth = -place.clone().applyMatrix4(camera.matrixWorldInverse).z;
  return 2 * Math.tan(camera.getEffectiveFOV() * Math.PI / 360) * Math.max(depth, 0.01) / window.innerHeight;
}
