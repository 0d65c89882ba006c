#pragma once

#include <pcl/core/plane_patch.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::acmap::boxes {

/** A polygon of a plane: a face of a box consists of such pieces, as coplanar faces of
 * different boxes may be one plane. */
struct Piece {
  std::size_t plane = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0;                               ///< normal * x + offset = 0
  std::vector<std::vector<Eigen::Vector3d>> loops; ///< metres; the outer one first
  double area = 0;                                 ///< square metres, without holes

  /** Distance of a place from the plane, positive on the side that was seen. */
  double
  height(const Eigen::Vector3d& place) const
  {
    return normal.dot(place) + offset;
  }
};

/** A half-space: normal * x <= position. */
struct HalfSpace {
  Eigen::Vector3d normal;
  double position;
};

/** \param[out] invalid number of planes that are not finite
 * \return the polygons with an area, in their order */
std::vector<Piece>
piecesOf(const std::vector<PlanePatch>& planes, std::size_t& invalid);

/** The part of a piece in a half-space. Its area is right; loops that the border cuts
 * into several parts remain one loop, with edges along the border. */
Piece
clipped(const Piece& piece, const HalfSpace& space);

/** Least and greatest coordinate along a direction; the first is above the second if
 * there are no points. */
std::pair<double, double>
rangeAlong(const Piece& piece, const Eigen::Vector3d& direction);

} // namespace pcl::acmap::boxes
