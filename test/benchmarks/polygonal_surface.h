#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Points with the planes that they are on. */
struct LabelledPoints {
  std::vector<Eigen::Vector3f> points;  ///< metres
  std::vector<std::int32_t> labels;     ///< index of a plane, -1 for none
  std::vector<Eigen::Vector3d> normals; ///< of the planes; each has points
};

/** \brief Faces of the closed surface that CGAL's Polygonal_surface_reconstruction
 * (PolyFit) selects with its default weights and GLPK; empty if the solver failed. */
std::vector<std::vector<Eigen::Vector3d>>
polygonalSurface(const LabelledPoints& input);

} // namespace pcl::acmap::bench
