#pragma once

#include "scene_truth.h"

#include "mesh_checker.h"

namespace pcl::acmap::bench {

/** \brief How representatives lie on one plane of the truth, away from where others that
 * are not parallel to it meet it. */
struct SheetFigures {
  std::size_t representatives = 0;
  double cover = 0; ///< percent of what is seen of it with one, turned as it, near
  double depth_error = 0; ///< mean distance, metres
  double p95_depth_error = 0;
  double shift = 0;  ///< mean distance towards the side it is seen from, metres
  double turned = 0; ///< percent with a normal into it
};

/** \brief Representatives belong to the surface nearest to them. One covers what lies
 * within a voxel of it along the surface and 3 cm off it. */
SheetFigures
measureSheet(const SceneTruth& truth,
             std::int32_t plane,
             const test::Points& places,
             const test::Points& normals,
             double voxel);

} // namespace pcl::acmap::bench
