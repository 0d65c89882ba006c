#pragma once

#include <pcl/texture/floor_plan.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief What is behind a part of the seen face of a wall. */
struct WallBody {
  /** \brief Begin and end of the face, then end and begin of its back, metres: a convex
   * quadrilateral, clockwise. */
  std::array<Eigen::Vector2d, 4> corners;
  std::size_t wall = 0;     ///< index of the face in the plan
  bool is_measured = false; ///< its back is a face that was seen, too
  bool has_face = true;     ///< else it only fills a corner
};

/** \brief Fills walls from each face to the nearest one that faces away from it, up to 0.6 m
 * behind it; where there is none, a strip behind the face. Where two faces meet, front and back
 * are continued to the lines of the other.
 * \param[in] plan whose walls are used, without furniture and leaves of doors
 * \param[in] strip metres */
std::vector<WallBody>
wallBodiesOf(const FloorPlan& plan, double strip);

} // namespace pcl::acmap
