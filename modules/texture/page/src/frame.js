// The frame of the map against that of the scene, whose y points up and whose axes follow the
// walls. Files and links have the first one, all that is drawn the second.

import {Matrix4, Quaternion, Vector3} from 'three';

const up_in_scene = new Vector3(0, 1, 0);

// The up direction in the frame of the map: as it says itself, else that of its cameras, else
// the axis by which map.glb was turned.
function upOf(map, node_rotation) {
  const isGiven = up => Array.isArray(up) && Math.hypot(...up) > 0.5;
  for (const up of [map.up, map.assumed_up])
    if (isGiven(up))
      return new Vector3(...up).normalize();
  const sum = new Vector3();
  for (const pose of map.trajectory ?? [])
    sum.add(new Vector3(0, -1, 0).applyQuaternion(new Quaternion(...pose.orientation)));
  return sum.length() > 0.1 ? sum.normalize()
                            : up_in_scene.clone().applyQuaternion(node_rotation.clone().invert());
}

// The least turn about the vertical, radians, that brings most area of the walls along the axes.
function turnAlongWalls(planes, tilt) {
  let x = 0, y = 0;
  for (const plane of planes) {
    const normal = new Vector3(...plane.coefficients).applyQuaternion(tilt);
    if (Math.abs(normal.y) > 0.2 || !(plane.area > 0))
      continue;
    const angle = 4 * Math.atan2(normal.z, normal.x); // walls repeat each quarter
    x += plane.area * Math.cos(angle);
    y += plane.area * Math.sin(angle);
  }
  return x === 0 && y === 0 ? 0 : Math.atan2(y, x) / 4;
}

export class Frame {
  // node: that of the surfaces in map.glb, which are relative to about the middle of the map
  constructor(map, node) {
    this.middle = node.translation.clone().applyQuaternion(node.rotation.clone().invert());
    const up = upOf(map, node.rotation);
    const tilt = node.rotation.clone();
    tilt.premultiply(new Quaternion().setFromUnitVectors(up.clone().applyQuaternion(tilt), up_in_scene));
    this.rotation = new Quaternion()
      .setFromAxisAngle(up_in_scene, turnAlongWalls(map.planes, tilt)).multiply(tilt);
    this.inverse = this.rotation.clone().invert();
    this.of_glb = new Matrix4()
      .makeRotationFromQuaternion(this.rotation.clone().multiply(node.rotation.clone().invert()))
      .multiply(new Matrix4().makeTranslation(node.translation.clone().negate()));
  }

  direction(array) { return new Vector3(...array).applyQuaternion(this.rotation); }

  place(array) { return new Vector3(...array).sub(this.middle).applyQuaternion(this.rotation); }

  placeInMap(place) {
    return place.clone().applyQuaternion(this.inverse).add(this.middle).toArray();
  }

  // a camera's orientation as map.json has it
  orientation(array) { return this.rotation.clone().multiply(new Quaternion(...array)); }
}
