// How accurate distances between planes are: their covariances at the places where a distance
// ends, less what both planes have in common by the errors of the poses (pcl/core/plane_distance.h).

// What a plane of map.json tells of its errors, in the scene; null if its noise is unknown.
export function errorsOf(plane, frame) {
  if (!plane.covariance || plane.covariance.flat().some(value => !Number.isFinite(value)))
    return null;
  return {center: frame.place(plane.center), axes: plane.axes.map(axis => frame.direction(axis)),
          normal: frame.direction(plane.coefficients.slice(0, 3)), covariance: plane.covariance,
          modes: plane.pose_modes ?? []};
}

const dot = (a, b) => a.reduce((sum, value, k) => sum + value * b[k], 0);

// How the distance along a direction changes with slopes and offset of a plane.
function gainsOf(errors, end, direction) {
  const arm = end.clone().sub(errors.center);
  const along = errors.normal.dot(direction);
  return [along * arm.dot(errors.axes[0]), along * arm.dot(errors.axes[1]), along];
}

const varianceOf = (errors, gains) => dot(gains, errors.covariance.map(row => dot(row, gains)));

// {sigma, at_least} of a distance that ends on two planes, metres; null where it is unknown.
// Across a plane its place is known, along it only that it was picked: then it is at least so.
export function uncertainty(first, second, ends) {
  const [a, b] = [first.item?.errors, second.item?.errors];
  const direction = ends[1].clone().sub(ends[0]).normalize();
  if (!a || !b || first.item === second.item || direction.length() === 0)
    return null;
  const [ga, gb] = [gainsOf(a, ends[0], direction), gainsOf(b, ends[1], direction)];
  let variance = varianceOf(a, ga) + varianceOf(b, gb);
  for (let k = 0; k < Math.min(a.modes.length, b.modes.length); ++k)
    variance -= 2 * dot(ga, a.modes[k]) * dot(gb, b.modes[k]);
  const across = Math.min(Math.abs(ga[2]), Math.abs(gb[2]));
  return {sigma: Math.sqrt(Math.max(0, variance)),
          at_least: a.modes.length === 0 || b.modes.length === 0 || across < 0.99};
}
