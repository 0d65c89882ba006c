#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/report.h>
#include <pcl/core/sensor_evidence.h>

#include <array>
#include <cstddef>

namespace pcl {

/** \brief Rule by which DeWallTriangulation accepts triangles. \ingroup surface */
enum class DeWallRule {
  /** The paper's empty sphere condition, with a guard: at most two triangles per edge
   * and one fan per vertex. */
  Guarded,
  /** The Delaunay-nearest apex without the sphere test, with the same guard. It covers
   * noisy surfaces more densely. */
  Dense,
  /** II-C.1 and Fig. 6 as printed: connected clusters first, walls down to single points,
   * no guard and no further pass. The mesh is not manifold; it is for comparison with the
   * paper. */
  Strict,
  Paper [[deprecated("is Guarded; the paper's own rule is Strict")]] = Guarded
};

/** \brief What the faces of a mesh look at. \ingroup surface */
enum class DeWallSides {
  Sensor,      ///< the sensor, which is known
  Normals,     ///< where the normals of the points point
  FreeSpace,   ///< the free space, by the up direction
  Outward,     ///< off what they enclose
  Undetermined ///< most of each component looks at the origin, which is perhaps no sensor
};

namespace acmap {

/** \brief The names of \ref DeWallSides in files and in Python. */
inline constexpr std::array<const char*, 5> dewall_sides_names{
    "sensor", "normals", "free_space", "outward", "undetermined"};

} // namespace acmap

/** \brief Report of the last run of \ref DeWallTriangulation. \ingroup surface */
struct DeWallReport : Report {
  std::size_t points = 0;           ///< points (or indices) given
  std::size_t invalid_points = 0;   ///< not finite, skipped
  std::size_t duplicate_points = 0; ///< repeated positions, skipped
  std::size_t used_points = 0;      ///< corners of at least one triangle
  std::size_t clusters = 0;         ///< connected clusters of at least three points
  std::size_t walls = 0;            ///< splitting planes at which triangles were built
  std::size_t triangles = 0;
  std::size_t edges = 0;
  std::size_t boundary_edges = 0;  ///< edges with one triangle
  std::size_t crowded_edges = 0;   ///< edges with more than two, only with Strict
  std::size_t components = 0;      ///< connected by edges of triangles
  std::size_t refused_moebius = 0; ///< triangles rejected for orientability
  std::size_t removed_fans = 0;    ///< triangles removed for one fan per vertex
  DeWallSides sides = DeWallSides::Undetermined;
  SensorEvidence sensor;           ///< unless the points have normals
  double median_spacing = 0;       ///< metres, between neighbouring points
  double min_maximum_edge = 0;     ///< metres, minimum of the size constraint
  double largest_maximum_edge = 0; ///< metres, maximum of the size constraint
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const DeWallReport& report, Visitor&& visit)
{
  visit({"points"}, report.points);
  visit({"invalid_points"}, report.invalid_points);
  visit({"duplicate_points"}, report.duplicate_points);
  visit({"used_points"}, report.used_points);
  visit({"clusters"}, report.clusters);
  visit({"walls"}, report.walls);
  visit({"triangles"}, report.triangles);
  visit({"edges"}, report.edges);
  visit({"boundary_edges"}, report.boundary_edges);
  visit({"crowded_edges"}, report.crowded_edges);
  visit({"components"}, report.components);
  visit({"refused_moebius"}, report.refused_moebius);
  visit({"removed_fans"}, report.removed_fans);
  visit({"sides"}, acmap::Named{report.sides, acmap::dewall_sides_names});
  visit({"sensor"}, report.sensor);
  visit({"median_spacing", "m"}, report.median_spacing);
  visit({"least_maximum_edge", "m"}, report.min_maximum_edge);
  visit({"largest_maximum_edge", "m"}, report.largest_maximum_edge);
}

namespace acmap {

/** \brief Estimates the memory of a triangulation beside its input, its result included.
 * Measured on raw clouds, the most demanding ones. While a \ref ScratchMemory exists, only
 * what stays in memory is counted.
 * \return bytes, an upper bound \ingroup surface */
ACMAP_EXPORT std::size_t
estimateDeWallMemory(std::size_t points, bool with_normals, DeWallRule rule);

} // namespace acmap
} // namespace pcl
