#pragma once

#include "scene_truth.h"

#include "mesh_checker.h"

namespace pcl::acmap::bench {

/** \brief Angles between normals and true normals, degrees. They are signed: a normal
 * that points into the wall is off by more than 90. */
struct NormalErrors {
  double median_away = 0; ///< away from creases, see \ref creaseMargin
  double p95_away = 0;
  double median_all = 0;
  double p95_all = 0;
  double backs_away = 0; ///< percentage of those that point into the surface
  double backs_all = 0;
};

/** \brief Compares each normal with that of the nearest surface; normals that are not
 * finite are ignored.
 * \param[in] places positions in the scene frame
 * \param[in] normals unit, scene frame
 * \param[in] voxel metres, for the distance to creases */
NormalErrors
measureNormals(const SceneTruth& truth,
               const test::Points& places,
               const test::Points& normals,
               double voxel);

/** \brief Comparison of a mesh with the truth. */
struct MeshFigures {
  NormalErrors normals; ///< of the faces
  double cover = 0;     ///< percentage of the visible raster with a triangle near it
  double overlap = 0;   ///< percentage with more than one triangle
  double area = 0;      ///< excess over the visible area, percent
  double boundary = 0;  ///< percentage of the edges with one triangle
};

/** \param[in] points scene frame
 * \param[in] voxel metres; a triangle covers the truth if their distance along the
 * normal of the truth is at most half a voxel or 5 cm, whichever is more */
MeshFigures
measureMesh(const SceneTruth& truth,
            const test::Points& points,
            const test::Triangles& triangles,
            double voxel);

} // namespace pcl::acmap::bench
