#include "recesses/opening.h"

#include "boxes/box.h"
#include "recesses/recess_sides.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::recesses {

using boxes::Piece;

Opening::Opening(const Piece& leaf, const Piece& wall, const Eigen::Vector3d& up)
{
  axes_.col(2) = wall.normal;
  axes_.col(1) = (up - up.dot(wall.normal) * wall.normal).normalized();
  axes_.col(0) = axes_.col(1).cross(axes_.col(2));
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const auto [low, high] = boxes::rangeAlong(leaf, axes_.col(axis));
    origin_ += (low + high) / 2 * axes_.col(axis);
    half_leaf_[axis] = (high - low) / 2;
  }
  origin_ -= wall.height(origin_) * wall.normal;
  depth_ = leaf.height(origin_) / leaf.normal.dot(wall.normal);
}

OpeningEnd
Opening::findEnd(const std::vector<Piece>& wall, std::size_t side) const
{
  constexpr int lines = 25;
  constexpr double middle = 0.8; // part of the leaf; its corners may be cut
  const Eigen::Index axis = 1 - boxes::Box::axisOf(side);
  std::vector<double> found;
  for (int line = 0; line < lines; ++line) {
    const double offset = middle * half_leaf_[axis] * (2 * (line + 0.5) / lines - 1);
    const Eigen::Vector3d from = origin_ + offset * axes_.col(axis);
    const double at = firstEdge(wall, from, outward(side), axes_.col(axis));
    if (std::isfinite(at))
      found.push_back(at);
  }
  OpeningEnd end;
  end.share = static_cast<double>(found.size()) / lines;
  if (found.empty())
    return end;
  std::sort(found.begin(), found.end());
  end.at = found[found.size() / 2];
  end.spread = found[3 * found.size() / 4] - found[found.size() / 4];
  return end;
}

Piece
Opening::within(Piece piece, double margin) const
{
  for (std::size_t side = 0; side < ends.size(); ++side)
    piece = boxes::clipped(
        piece, {outward(side), outward(side).dot(origin_) + ends[side] + margin});
  return piece;
}

std::pair<double, double>
Opening::rangeOf(const Piece& piece, Eigen::Index axis) const
{
  const auto [least, greatest] = boxes::rangeAlong(piece, axes_.col(axis));
  const double zero = axes_.col(axis).dot(origin_);
  return {least - zero, greatest - zero};
}

double
Opening::width() const
{
  return ends[right_side] + ends[left_side];
}

double
Opening::height() const
{
  return ends[head_side] + ends[foot_side];
}

Eigen::Vector3d
Opening::outward(std::size_t side) const
{
  return (side % 2 == 0 ? 1 : -1) * axes_.col(boxes::Box::axisOf(side));
}

/** Distance of the first edge of the wall along a direction; infinite if there is none.
 * \param[in] across direction in the wall at a right angle to it */
double
Opening::firstEdge(const std::vector<Piece>& wall,
                   const Eigen::Vector3d& from,
                   const Eigen::Vector3d& direction,
                   const Eigen::Vector3d& across) const
{
  double first = std::numeric_limits<double>::infinity();
  for (const Piece& piece : wall)
    for (const std::vector<Eigen::Vector3d>& loop : piece.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Eigen::Vector3d &a = loop[i], &b = loop[(i + 1) % loop.size()];
        const double before = across.dot(a - from), after = across.dot(b - from);
        if ((before <= 0) == (after <= 0))
          continue;
        const Eigen::Vector3d place = a + before / (before - after) * (b - a);
        const double at = direction.dot(place - from);
        if (at > 0)
          first = std::min(first, at);
      }
  return first;
}

} // namespace pcl::acmap::recesses
