// Which plane or cylinder a triangle of map.glb belongs to: the file has them by page of the
// atlas, without their numbers.

import {Vector3} from 'three';

import {axesOf, boundsOf, flatLoop, isWithin} from './polygons.js';

const near = 0.002; // metres: more than floats far from the middle of the map err

class PlaneShape {
  constructor(id, plane, frame) {
    this.kind = 'plane';
    this.id = id;
    this.normal = frame.direction(plane.coefficients);
    this.axes = axesOf(this.normal);
    this.loops = plane.polygons.flatMap(polygon => [polygon.outer, ...(polygon.holes ?? [])])
      .map(loop => flatLoop(loop.map(p => frame.place(p)), this.axes));
    this.bounds = boundsOf(this.loops);
    this.offset = plane.polygons.length > 0
      ? -this.normal.dot(frame.place(plane.polygons[0].outer[0])) : Infinity;
  }

  holds(middle, normal) {
    if (Math.abs(this.normal.dot(middle) + this.offset) > near || this.normal.dot(normal) < 0.999)
      return false;
    const [x, y] = [middle.dot(this.axes[0]), middle.dot(this.axes[1])];
    const [left, bottom, right, top] = this.bounds;
    return x > left - near && x < right + near && y > bottom - near && y < top + near;
  }

  covers(middle, normal) {
    return this.holds(middle, normal) && isWithin(this.loops, [middle.dot(this.axes[0]), middle.dot(this.axes[1])]);
  }
}

class CylinderShape {
  constructor(id, cylinder, frame) {
    this.kind = 'cylinder';
    this.id = id;
    this.point = frame.place(cylinder.axis_point);
    this.direction = frame.direction(cylinder.axis_direction);
    this.radius = cylinder.radius;
    this.extent = cylinder.extent;
    this.offset = new Vector3();
  }

  covers(middle) {
    const offset = this.offset.subVectors(middle, this.point);
    const along = offset.dot(this.direction);
    const radius = offset.addScaledVector(this.direction, -along).length();
    const slack = 0.01 + 0.1 * this.radius; // facets are inside of the arc
    return along > this.extent[0] - near && along < this.extent[1] + near &&
           Math.abs(radius - this.radius) < slack;
  }
}

export class Belonging {
  constructor(map, frame) {
    this.planes = map.planes.map((plane, id) => new PlaneShape(id, plane, frame));
    this.cylinders = (map.cylinders ?? []).map((cylinder, id) => new CylinderShape(id, cylinder, frame));
    this.last = null;
  }

  // The shape that a triangle belongs to, which has a kind, 'plane' or 'cylinder', and an id; or null
  of(a, b, c) {
    const normal = new Vector3().subVectors(b, a).cross(new Vector3().subVectors(c, a)).normalize();
    const middle = new Vector3().add(a).add(b).add(c).divideScalar(3);
    // triangles of one surface follow each other
    if (!this.last?.covers(middle, normal)) {
      const candidates = this.planes.filter(plane => plane.holds(middle, normal));
      this.last = candidates.find(plane => plane.covers(middle, normal)) ?? candidates[0] ??
        this.cylinders.find(shape => shape.covers(middle)) ?? null;
    }
    return this.last;
  }
}
