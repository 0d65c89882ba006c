#pragma once

#include "scene_truth.h"

#include "mesh_checker.h"

namespace pcl::acmap::bench {

/** \brief How normals deviate from the true ones, degrees. They are signed: one that looks
 * into the wall is off by more than 90. */
struct NormalErrors {
  double median_away = 0; ///< away from creases, see \ref creaseMargin
  double p95_away = 0;
  double median_all = 0;
  double p95_all = 0;
  double backs_away = 0; ///< percent of those that look into the surface
  double backs_all = 0;
};

/** \brief Compares each normal with that of the surface nearest to its place; normals that
 * are not finite are left out.
 * \param[in] places scene frame
 * \param[in] normals unit, scene frame
 * \param[in] voxel metres, for the distance to creases */
NormalErrors
measureNormals(const SceneTruth& truth,
               const test::Points& places,
               const test::Points& normals,
               double voxel);

/** \brief How a mesh lies on the truth. */
struct MeshFigures {
  NormalErrors normals; ///< of the faces
  double cover = 0;     ///< percent of the visible raster under a triangle near to it
  double overlap = 0;   ///< percent under more than one
  double area = 0;      ///< percent more than the visible area
  double boundary = 0;  ///< percent of the edges with one triangle
};

/** \param[in] points scene frame
 * \param[in] voxel metres; half of it, and 5 cm at least, may lie between a triangle and
 * the part of the truth it covers, along the normal of the truth */
MeshFigures
measureMesh(const SceneTruth& truth,
            const test::Points& points,
            const test::Triangles& triangles,
            double voxel);

} // namespace pcl::acmap::bench
