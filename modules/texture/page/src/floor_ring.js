// The ring on the floor to which a click would walk.

import {Mesh, MeshBasicMaterial, RingGeometry} from 'three';

export class FloorRing {
  constructor(scene) {
    const material = new MeshBasicMaterial({color: 0xffffff, transparent: true, opacity: 0.85, toneMapped: false});
    this.ring = new Mesh(new RingGeometry(0.16, 0.2, 40).rotateX(-Math.PI / 2), material);
    this.ring.raycast = () => {};
    this.ring.visible = false;
    scene.add(this.ring);
  }

  hide() { this.ring.visible = false; }

  // place: on a floor, or null. Has anything changed?
  follow(place) {
    const was_visible = this.ring.visible;
    this.ring.visible = Boolean(place);
    if (place)
      this.ring.position.copy(place).setY(place.y + 0.01);
    return was_visible || this.ring.visible;
  }
}
