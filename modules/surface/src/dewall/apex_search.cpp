#include "apex_search.h"

#include "ball_visit.h"
#include <limits>

namespace pcl::acmap::ACMAP_DEWALL {

SideFrame::SideFrame(const PointTree& tree,
                     const SizeConstraint& size,
                     std::int32_t a_index,
                     std::int32_t b_index,
                     std::int32_t opposite)
: SideFrame(tree,
            std::min(size.longest(a_index), size.longest(b_index)),
            a_index,
            b_index,
            opposite)
{}

SideFrame::SideFrame(const PointTree& tree,
                     double longest_at_ends,
                     std::int32_t a_index,
                     std::int32_t b_index,
                     std::int32_t opposite)
: SideFrame(tree, longest_at_ends, a_index, b_index)
{
  outward =
      -perpendicular(origin, tree.position(b), tree.position(opposite)).normalized();
}

SideFrame::SideFrame(const PointTree& tree,
                     double longest_at_ends,
                     std::int32_t a_index,
                     std::int32_t b_index)
: a(a_index)
, b(b_index)
, origin(tree.position(a_index))
, u(tree.position(b_index) - origin)
, outward(Eigen::Vector3d::Zero())
, half_length(u.norm() / 2)
, longest(longest_at_ends)
{}

namespace {

/** \brief Keeps the nearest apex among points that are tested one by one. */
class NearestApex {
public:
  NearestApex(const PointTree& tree, const SizeConstraint& size, const SideFrame& side)
  : tree_(tree)
  , size_(size)
  , side_(side)
  {}

  /** \brief Returns true if the point is the nearest so far. */
  bool
  consider(std::int32_t i)
  {
    const Apex apex = makeApex(i, side_.u, tree_.position(i) - side_.origin);
    if (!isApexAllowed(size_, side_, apex) ||
        (best_.index >= 0 && !isNearerApex(apex, best_, side_.a, side_.b, side_.u)))
      return false;
    best_ = apex;
    return true;
  }

  const Apex&
  best() const
  {
    return best_;
  }

private:
  const PointTree& tree_;
  const SizeConstraint& size_;
  const SideFrame& side_;
  Apex best_;
};

/** \brief Search without SIMD, for more ties than the result can hold and for values
 * outside of the range of floats. */
std::int32_t
findApexOneByOne(const PointTree& tree,
                 const SizeConstraint& size,
                 const SideFrame& side,
                 const PassedOver& passed_over)
{
  NearestApex nearest(tree, size, side);
  double radius = reachFromMiddle(side);
  const double h = side.half_length;
  const auto visit = [&](std::int32_t, std::int32_t first, std::int32_t end) {
    for (std::int32_t i = first; i < end; ++i) {
      if (i == side.a || i == side.b || passed_over.contains(tree, i) ||
          !nearest.consider(i))
        continue;
      // All better apexes are in balls through a and b, hence within this distance of
      // the middle.
      const double t = h * nearest.best().dot / nearest.best().cross;
      radius = std::min(radius, t > 0 ? t + std::sqrt(t * t + h * h) : h);
    }
  };
  visitBall(tree, side.a, side.origin + 0.5 * side.u, radius, visit);
  return nearest.best().index;
}

bool
isSphereEmptyOneByOne(const PointTree& tree,
                      const std::array<std::int32_t, 3>& corners,
                      const Sphere& sphere)
{
  const double inside = sphere.radius * (1 - sphere_tolerance);
  double radius = inside;
  const auto visit = [&](std::int32_t, std::int32_t first, std::int32_t end) {
    for (std::int32_t i = first; i < end; ++i)
      if ((tree.position(i) - sphere.centre).squaredNorm() < inside * inside &&
          i != corners[0] && i != corners[1] && i != corners[2])
        radius = -1;
  };
  visitBall(tree, corners[2], sphere.centre, radius, visit);
  return radius >= 0;
}

} // namespace

ApexQuery
apexQuery(const PointTree& tree, const SideFrame& side)
{
  ApexQuery query{};
  query.a = side.a;
  query.b = side.b;
  query.left_out = -1;
  query.leaf = tree.leafOf(side.a);
  const Eigen::Vector3d along = side.u / (2 * side.half_length);
  for (int axis = 0; axis < 3; ++axis) {
    query.at_a[axis] = tree.coordinates(axis)[side.a];
    query.at_b[axis] = tree.coordinates(axis)[side.b];
    query.along[axis] = static_cast<float>(along[axis]);
    query.outward[axis] = static_cast<float>(side.outward[axis]);
  }
  query.length = static_cast<float>(2 * side.half_length);
  query.longest = static_cast<float>(side.longest);
  query.reach = static_cast<float>(reachFromMiddle(side));
  return query;
}

ApexQuery
apexQuery(const PointTree& tree,
          const SizeConstraint& size,
          const SideFrame& side,
          const PassedOver& passed_over)
{
  ApexQuery query = apexQuery(tree, side);
  query.left_out = passed_over.point;
  query.longest_at = size.longestOfLeaves();
  query.masks = passed_over.masks;
  query.first_masked = passed_over.first_leaf;
  query.end_masked = passed_over.end_leaf;
  return query;
}

BallQuery
ballQuery(const PointTree& tree,
          const std::array<std::int32_t, 3>& corners,
          const Sphere& sphere)
{
  const Eigen::Vector3d origin = tree.position(corners[2]);
  BallQuery query;
  query.leaf = tree.leafOf(corners[2]);
  query.radius = static_cast<float>(sphere.radius);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<int>(i);
    query.corners[i] = corners[i];
    query.origin[i] = static_cast<float>(origin[axis]);
    query.centre[i] = static_cast<float>(sphere.centre[axis] - origin[axis]);
    query.middle[i] = static_cast<float>(sphere.centre[axis]);
  }
  return query;
}

std::int32_t
findApex(const PointTree& tree,
         const SizeConstraint& size,
         const SideFrame& side,
         const PassedOver& passed_over)
{
  if (!isWithinFloats(side.half_length))
    return findApexOneByOne(tree, size, side, passed_over);
  SearchHits hits;
  findApexCandidates(tree.cells(), apexQuery(tree, size, side, passed_over), hits);
  if (hits.count > SearchHits::capacity)
    return findApexOneByOne(tree, size, side, passed_over);
  if (hits.is_decided)
    return hits.index[0];
  NearestApex nearest(tree, size, side);
  for (std::int32_t i = 0; i < hits.count; ++i)
    nearest.consider(hits.index[i]);
  return nearest.best().index;
}

bool
isApexAllowed(const SizeConstraint& size, const SideFrame& side, const Apex& apex)
{
  const double base = 2 * side.half_length;
  const double squared = apex.from_a.squaredNorm();
  const double other = (apex.from_a - side.u).squaredNorm();
  const double longest = std::max(base * base, std::max(squared, other));
  const double limit = std::min(side.longest, size.longest(apex.index));
  return apex.cross > min_sine * longest && apex.from_a.dot(side.outward) > 0 &&
         std::max(squared, other) <= limit * limit;
}

bool
isSphereEmpty(const PointTree& tree,
              const std::array<std::int32_t, 3>& corners,
              std::int32_t first_tested)
{
  const Sphere sphere = sphereOf(tree, corners);
  const double inside = sphere.radius * (1 - sphere_tolerance);
  const auto isInside = [&](std::int32_t i) {
    return (tree.position(i) - sphere.centre).squaredNorm() < inside * inside;
  };
  if (first_tested >= 0 && isInside(first_tested))
    return false;
  if (!isWithinFloats(sphere.radius))
    return isSphereEmptyOneByOne(tree, corners, sphere);
  SearchHits hits;
  if (findInBall(tree.cells(), ballQuery(tree, corners, sphere), hits))
    return false;
  if (hits.count > SearchHits::capacity)
    return isSphereEmptyOneByOne(tree, corners, sphere);
  return std::none_of(hits.index, hits.index + hits.count, isInside);
}

} // namespace pcl::acmap::ACMAP_DEWALL
