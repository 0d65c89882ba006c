#include "boxes/piece.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap::boxes {

namespace {

using Points = std::vector<Eigen::Vector3d>;

double
signedArea(const Points& loop, const Eigen::Vector3d& normal)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 2; i < loop.size(); ++i)
    sum += (loop[i - 1] - loop[0]).cross(loop[i] - loop[0]);
  return sum.dot(normal) / 2;
}

void
measureArea(Piece& piece)
{
  piece.area = 0;
  for (const Points& loop : piece.loops)
    piece.area += signedArea(loop, piece.normal); // those of holes are negative
}

Points
pointsOf(const std::vector<Eigen::Vector3f>& loop)
{
  Points points;
  for (const Eigen::Vector3f& point : loop)
    points.push_back(point.cast<double>());
  return points;
}

bool
isFinite(const Piece& piece)
{
  for (const Points& loop : piece.loops)
    for (const Eigen::Vector3d& point : loop)
      if (!point.allFinite())
        return false;
  return true;
}

Points
clippedLoop(const Points& loop, const HalfSpace& space)
{
  Points kept;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector3d &from = loop[i], &to = loop[(i + 1) % loop.size()];
    const double before = space.normal.dot(from) - space.position,
                 after = space.normal.dot(to) - space.position;
    if (before <= 0)
      kept.push_back(from);
    if ((before <= 0) != (after <= 0))
      kept.push_back(from + before / (before - after) * (to - from));
  }
  return kept;
}

bool
isSound(const PlanePatch& plane)
{
  constexpr double slack = 1e-6;
  return plane.coefficients.allFinite() && plane.center.allFinite() &&
         plane.axis_u.allFinite() && plane.axis_v.allFinite() &&
         std::abs(plane.coefficients.head<3>().norm() - 1) <= slack;
}

} // namespace

std::vector<Piece>
piecesOf(const std::vector<PlanePatch>& planes, std::size_t& invalid)
{
  std::vector<Piece> pieces;
  invalid = 0;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (!isSound(planes[p])) {
      ++invalid;
      continue;
    }
    for (const PlanePolygon& polygon : planes[p].polygons) {
      Piece piece;
      piece.plane = p;
      piece.normal = planes[p].coefficients.head<3>();
      piece.offset = planes[p].coefficients[3];
      piece.loops.push_back(pointsOf(polygon.outer));
      for (const std::vector<Eigen::Vector3f>& hole : polygon.holes)
        piece.loops.push_back(pointsOf(hole));
      measureArea(piece);
      if (isFinite(piece) && piece.area > 0)
        pieces.push_back(std::move(piece));
    }
  }
  return pieces;
}

Piece
clipped(const Piece& piece, const HalfSpace& space)
{
  Piece part{piece.plane, piece.normal, piece.offset, {}, 0};
  for (const Points& loop : piece.loops)
    part.loops.push_back(clippedLoop(loop, space));
  measureArea(part);
  return part;
}

std::pair<double, double>
rangeAlong(const Piece& piece, const Eigen::Vector3d& direction)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::pair<double, double> range{infinity, -infinity};
  for (const Points& loop : piece.loops)
    for (const Eigen::Vector3d& point : loop) {
      range.first = std::min(range.first, direction.dot(point));
      range.second = std::max(range.second, direction.dot(point));
    }
  return range;
}

} // namespace pcl::acmap::boxes
