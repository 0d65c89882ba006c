// The standard deviation of a distance between two picks, metres, or null where it is unknown.
// Nothing is told of it before maps state the covariances of pairs of planes.
export function uncertainty(/* first, second */) {
  return null;
}
