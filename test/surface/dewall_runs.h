#pragma once

#include "clouds.h"
#include "mesh_checker.h"

#include <pcl/surface/dewall_triangulation.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Valid triangles with a fold of at most this angle, radians, must all exist.
 * The kernel grows over an edge up to this fold, and closes sharper folds from other
 * edges. */
inline constexpr double turn_limit = 90.0 / 180.0 * 3.14159265358979323846;

/** \brief A cloud with the size constraint of its mesh (0: automatic). */
struct DeWallCase {
  std::string name;
  Cloud cloud;
  double length = 0;
};

/** \brief All synthetic clouds, small enough to check each mesh by brute force. */
const std::vector<DeWallCase>&
syntheticCases();

/** \brief Settings of a run. */
struct DeWallRun {
  DeWallRule rule = DeWallRule::Guarded;
  double length = 0;
  unsigned threads = 1;
  bool depth = false;
};

struct DeWallResult {
  Points points;
  TriangleMesh mesh;
  DeWallReport report;
};

DeWallResult
triangulate(const Cloud& cloud, const DeWallRun& run);

/** \brief As above with a leaf size of the kernel's divide step, so that small clouds
 * get walls too. */
DeWallResult
triangulateInLeaves(const Cloud& cloud, const DeWallRun& run, std::int32_t leaf_size);

/** \brief Checks the guarantees of the rule; fails with the numbers of faults. */
testing::AssertionResult
keepsGuarantees(const DeWallResult& result, const DeWallRun& run);

/** \brief Triangles as sorted sets of vertices, in sorted order: independent of order
 * and rotation. */
Triangles
asSets(Triangles triangles);

/** \brief As above, after replacing vertex i by names[i]. */
Triangles
asSets(const Triangles& triangles, const std::vector<std::int32_t>& names);

std::string
nameOf(DeWallRule rule);

} // namespace pcl::acmap::test
