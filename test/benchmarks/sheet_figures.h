#pragma once

#include "scene_truth.h"

#include "mesh_checker.h"

namespace pcl::acmap::bench {

/** \brief Comparison of representatives with one true plane, except near other planes
 * that are not parallel to it. */
struct SheetFigures {
  std::size_t representatives = 0;
  double cover = 0; ///< percentage of its visible part with a representative of the
                    ///< same orientation nearby
  double depth_error = 0; ///< mean distance, metres
  double p95_depth_error = 0;
  double shift = 0;  ///< mean distance towards the observed side, metres
  double turned = 0; ///< percentage of normals that point into the surface
};

/** \brief Representatives belong to the nearest surface. Each one covers the area
 * within a voxel along the surface if its distance to the surface is at most 3 cm. */
SheetFigures
measureSheet(const SceneTruth& truth,
             std::int32_t plane,
             const test::Points& places,
             const test::Points& normals,
             double voxel);

} // namespace pcl::acmap::bench
