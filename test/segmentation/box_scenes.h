#pragma once

#include <pcl/core/plane_patch.h>
#include <pcl/core/random.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Planes of a map that are rectangles. Its y axis points down, as in scenes of
 * the simulation. */
class RectangleMap {
public:
  /** \brief Adds a rectangle, seen from the side of edge_u x edge_v.
   * \return the number of its plane */
  std::int32_t
  add(const Eigen::Vector3d& corner,
      const Eigen::Vector3d& edge_u,
      const Eigen::Vector3d& edge_v);

  /** \brief Adds faces of a box as planes that are seen from outside.
   * \param[in] faces of "+x", "-x" and so on, joined: "+x-y" is the right side and the
   * top */
  void
  addBox(const Eigen::Vector3d& least,
         const Eigen::Vector3d& most,
         const std::string& faces);

  /** \brief Adds the six sides of a room, seen from inside: floor, ceiling, walls. */
  void
  addRoom(const Eigen::Vector3d& least, const Eigen::Vector3d& most);

  /** \brief Turns all normals. */
  void
  turnInsideOut();

  std::vector<PlanePatch> planes;
};

/** \brief The planes in another frame. */
std::vector<PlanePatch>
transformed(std::vector<PlanePatch> planes, const Eigen::Isometry3d& T_b_a);

/** \brief The planes with errors as their covariances tell them.
 * \param[in] factor of the errors */
std::vector<PlanePatch>
disturbed(std::vector<PlanePatch> planes, Random& random, double factor);

} // namespace pcl::acmap::test
