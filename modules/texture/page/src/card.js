// The card of what was chosen, and its mark in the picture.

import {LineMaterial} from 'three/addons/lines/LineMaterial.js';
import {LineSegments2} from 'three/addons/lines/LineSegments2.js';
import {LineSegmentsGeometry} from 'three/addons/lines/LineSegmentsGeometry.js';

import {edgesOf} from './polygons.js';

const byId = id => document.getElementById(id);

// Thick lines between pairs of places, in front of everything.
export function thickLines(places, colour, width) {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(places.flatMap(p => [p.x, p.y, p.z]));
  const material = new LineMaterial({color: colour, linewidth: width, depthTest: false, transparent: true,
                                     toneMapped: false});
  const segments = new LineSegments2(geometry, material);
  segments.renderOrder = 2;
  segments.frustumCulled = false;
  segments.raycast = () => {};
  return segments;
}

export class Card {
  constructor(scene, closed) {
    this.scene = scene;
    this.item = null;
    this.mark = null;
    byId('card').querySelector('.close').addEventListener('click', closed);
  }

  show(item) {
    this.clearMark();
    this.item = item;
    byId('card').hidden = !item;
    if (!item)
      return;
    byId('name').textContent = item.name;
    byId('line').textContent = item.line;
    byId('openings').replaceChildren(...item.openings.map(text => {
      const entry = document.createElement('li');
      entry.textContent = text;
      return entry;
    }));
    byId('values').replaceChildren();
    for (const [key, value] of item.rows) {
      const row = byId('values').insertRow();
      row.insertCell().textContent = key;
      row.insertCell().textContent = value;
    }
    const places = edgesOf(item.loops);
    if (places.length > 0)
      this.scene.add(this.mark = thickLines(places, 0xf0a000, 3));
  }

  clearMark() {
    if (!this.mark)
      return;
    this.scene.remove(this.mark);
    this.mark.geometry.dispose();
    this.mark.material.dispose();
    this.mark = null;
  }
}
