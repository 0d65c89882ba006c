#pragma once

#include <pcl/core/export.h>
#include <pcl/core/report.h>

#include <cstddef>

namespace pcl {

/** \brief How DeWallTriangulation accepts a triangle. \ingroup surface */
enum class DeWallRule {
  /** The paper's empty sphere, and at most two triangles a side, one fan a vertex. */
  Paper,
  /** The Delaunay-nearest apex without the sphere test, with the same guard: covers
   * noisy surfaces more densely. */
  Dense,
  /** The paper's rule as printed, without guard: for study, the mesh is not manifold.
   */
  Strict
};

/** \brief What a \ref DeWallTriangulation did. \ingroup surface */
struct DeWallReport : Report {
  std::size_t points = 0;         ///< points (or indices) given
  std::size_t invalid_points = 0; ///< of these not finite, skipped
  std::size_t duplicate_points =
      0;                       ///< of these at the place of an earlier one, skipped
  std::size_t used_points = 0; ///< corners of at least one triangle
  std::size_t clusters = 0;    ///< connected clusters of at least three points
  std::size_t triangles = 0;
  std::size_t edges = 0;
  std::size_t boundary_edges = 0;  ///< edges with one triangle
  std::size_t components = 0;      ///< of triangles that share edges
  std::size_t refused_moebius = 0; ///< triangles refused to keep components orientable
  std::size_t removed_fans = 0;    ///< triangles removed to leave one fan a vertex
  double median_spacing = 0;       ///< metres, between neighbouring points
  double least_maximum_edge = 0;   ///< metres, the size constraint where densest
  double largest_maximum_edge = 0; ///< metres, the size constraint where sparsest
};

namespace acmap {

/** \brief Estimates the memory of a triangulation beside its input, its result included.
 * Measured on raw clouds, the most demanding ones.
 * \return bytes, an upper bound \ingroup surface */
ACMAP_EXPORT std::size_t
estimateDeWallMemory(std::size_t points, bool with_normals);

} // namespace acmap
} // namespace pcl
