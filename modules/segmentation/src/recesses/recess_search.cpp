#include "recesses/recess_search.h"

#include "boxes/box_pose.h"
#include "recesses/recess_sides.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl::acmap::recesses {

using boxes::Box;
using boxes::Piece;
using boxes::Side;

namespace {

constexpr double max_skew = 0.07;      ///< 4 degrees, as sine
constexpr double outline_error = 0.03; ///< metres; of the polygons
constexpr double max_gap = 0.08;       ///< metres; between a floor and the piece on it
constexpr double rim_deviation = 0.01; ///< metres, standard deviation; of outlines
constexpr double min_floor = 0.2;      ///< metres; that a floor continues before a wall
constexpr double min_depth = 0.03;     ///< metres; less is a step in a wall, or drift
constexpr double max_depth = 0.5;   ///< metres; more is a room, seen through a passage
constexpr double min_width = 0.2;   ///< metres; of both sides of an opening
constexpr double min_cover = 0.55;  ///< share of the opening that the leaf covers
constexpr double max_blocked = 0.1; ///< share of the opening that the wall covers
constexpr double min_inside = 0.88; ///< share of a leaf that is in the opening
constexpr double min_rim = 0.8;     ///< share of a side at which the wall begins
constexpr double infinity = std::numeric_limits<double>::infinity();

bool
isParallel(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return a.dot(b) > 0 && a.cross(b).norm() < max_skew;
}

/** A plane described at another place of it. */
PlanePatch
movedTo(PlanePatch plane, const Eigen::Vector3d& place)
{
  const Eigen::Vector3d normal = plane.coefficients.head<3>();
  const Eigen::Vector3d center =
      place - (normal.dot(place) + plane.coefficients[3]) * normal;
  const Eigen::Vector3d shift = center - plane.center;
  Eigen::Matrix3d change = Eigen::Matrix3d::Identity();
  change.row(2) << plane.axis_u.dot(shift), plane.axis_v.dot(shift), 1;
  plane.covariance = change * plane.covariance * change.transpose();
  plane.center = center;
  return plane;
}

} // namespace

RecessSearch::RecessSearch(const std::vector<PlanePatch>& planes,
                           const std::vector<Piece>& pieces,
                           const Eigen::Vector3d& up)
: planes_(planes)
, pieces_(pieces)
, up_(up)
, pieces_of_(planes.size())
{
  for (std::size_t i = 0; i < pieces.size(); ++i)
    pieces_of_[pieces[i].plane].push_back(i);
  for (std::size_t leaf = 0; leaf < pieces.size(); ++leaf)
    for (std::size_t wall = 0; wall < planes.size(); ++wall) {
      if (pieces_of_[wall].empty() || wall == pieces[leaf].plane)
        continue;
      const Piece& one = pieces[pieces_of_[wall].front()];
      if (std::abs(one.normal.dot(up)) > max_skew ||
          !isParallel(one.normal, pieces[leaf].normal))
        continue;
      const double depth = Opening(pieces[leaf], one, up).depth();
      if (depth > min_depth && depth < max_depth)
        pairs_.push_back({leaf, wall});
    }
}

/** The floor on which an opening stands, whose lower side is not known yet: the first
 * one below its origin. */
std::optional<std::size_t>
RecessSearch::floorBelow(const Opening& opening) const
{
  std::optional<std::size_t> floor;
  double nearest = infinity;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    const double below = piece.height(opening.origin());
    const auto [left, right] = opening.rangeOf(piece, 0);
    const auto [back, front] = opening.rangeOf(piece, 2); // a sill ends at the wall
    if (isParallel(piece.normal, up_) && below > 0 && below < nearest &&
        left < opening.ends[right_side] && right > -opening.ends[left_side] &&
        back < max_gap && front > min_floor) {
      nearest = below;
      floor = i;
    }
  }
  return floor;
}

/** Finds the sides of an opening in the plane of a wall.
 * \param[out] foot the lower side
 * \return false if it is no rectangle, or has no end below */
bool
RecessSearch::close(Opening& opening, std::size_t wall, Side& foot) const
{
  constexpr double plane_deviation = 0.002; // metres
  std::vector<Piece> pieces;
  for (const std::size_t piece : pieces_of_[wall])
    pieces.push_back(pieces_[piece]);
  std::array<OpeningEnd, 4> ends;
  for (const std::size_t side : {right_side, left_side, head_side, foot_side}) {
    ends[side] = opening.findEnd(pieces, side);
    opening.ends[side] = ends[side].at;
    const bool is_straight =
        ends[side].share >= min_rim && ends[side].spread <= outline_error;
    if (side != foot_side && !is_straight)
      return false;
  }
  const bool is_open = ends[foot_side].share < min_rim;
  const std::optional<std::size_t> floor = floorBelow(opening);
  if (floor) {
    const double below = pieces_[*floor].height(opening.origin()) /
                         pieces_[*floor].normal.dot(opening.axes().col(1));
    if (is_open || std::abs(below - ends[foot_side].at) < max_gap) {
      opening.ends[foot_side] = below;
      foot.kind = BoxFaceKind::Snapped;
      foot.plane = static_cast<std::int32_t>(pieces_[*floor].plane);
      foot.deviation = plane_deviation;
      return true;
    }
  }
  foot.deviation = rim_deviation;
  return !is_open && ends[foot_side].spread <= outline_error;
}

/** Share of the opening, up to its edges, that the wall covers. */
double
RecessSearch::coverOfWall(const Opening& opening, std::size_t wall) const
{
  double covered = 0;
  for (const std::size_t piece : pieces_of_[wall])
    covered += opening.within(pieces_[piece], -outline_error).area;
  return covered / ((opening.width() - 2 * outline_error) *
                    (opening.height() - 2 * outline_error));
}

/** The pieces of a plane in the opening. */
std::vector<std::size_t>
RecessSearch::leavesIn(const Opening& opening, std::size_t plane) const
{
  std::vector<std::size_t> leaves;
  for (const std::size_t piece : pieces_of_[plane])
    if (opening.within(pieces_[piece], outline_error).area >=
        min_inside * pieces_[piece].area)
      leaves.push_back(piece);
  return leaves;
}

Box
RecessSearch::boxOf(const Opening& opening, const Side& foot) const
{
  constexpr double turn_deviation = 0.005; // radians; of the vertical direction
  Box box;
  box.axes = opening.axes();
  box.turn_deviation = turn_deviation;
  box.sides[foot_side] = foot;
  for (const std::size_t side : {right_side, left_side, head_side})
    box.sides[side].deviation = rim_deviation;
  for (std::size_t side = 0; side < opening.ends.size(); ++side)
    box.sides[side].position = opening.ends[side];
  box.sides[leaf_side].position = opening.depth();
  box.origin = opening.origin();
  const Eigen::Vector3d half = box.size() / 2;
  box.origin = box.center();
  for (std::size_t side = 0; side < box.sides.size(); ++side)
    box.sides[side].position = half[Box::axisOf(side)];
  box.sides[wall_side].kind = box.sides[leaf_side].kind = BoxFaceKind::Seen;
  return box;
}

/** Fits a box to wall and leaf where it is: both may be long, and are known best there. */
void
RecessSearch::fitToPlanes(Box& box) const
{
  const std::array<std::size_t, 2> sides{wall_side, leaf_side};
  std::array<std::int32_t, 2> numbers{};
  std::vector<PlanePatch> here;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    std::int32_t& plane = box.sides[sides[i]].plane;
    numbers[i] = plane;
    here.push_back(movedTo(planes_[static_cast<std::size_t>(plane)], box.origin));
    plane = static_cast<std::int32_t>(i);
  }
  boxes::fitPose(here, box);
  for (std::size_t i = 0; i < sides.size(); ++i)
    box.sides[sides[i]].plane = numbers[i];
}

std::optional<Box>
RecessSearch::fit(const LeafBehindWall& pair) const
{
  const Piece& leaf = pieces_[pair.leaf];
  Opening opening(leaf, pieces_[pieces_of_[pair.wall].front()], up_);
  Side foot;
  if (!close(opening, pair.wall, foot) || !(opening.width() > min_width) ||
      !(opening.height() > min_width) || coverOfWall(opening, pair.wall) > max_blocked)
    return std::nullopt;
  const std::vector<std::size_t> leaves = leavesIn(opening, leaf.plane);
  double covered = 0;
  for (const std::size_t piece : leaves)
    covered += pieces_[piece].area;
  if (covered < min_cover * opening.width() * opening.height())
    return std::nullopt;
  Box box = boxOf(opening, foot);
  box.sides[wall_side].plane = static_cast<std::int32_t>(pair.wall);
  box.sides[leaf_side].plane = static_cast<std::int32_t>(leaf.plane);
  box.sides[leaf_side].pieces = leaves;
  fitToPlanes(box);
  if (!(box.size().minCoeff() > min_depth))
    return std::nullopt;
  return box;
}

} // namespace pcl::acmap::recesses
