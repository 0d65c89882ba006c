#pragma once

#include "clouds.h"
#include "mesh_checker.h"

#include <pcl/surface/dewall_triangulation.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Legal triangles that fold no sharper than this, radians, must all be there. The
 * kernel grows over a side up to it, and closes sharper folds at its other sides. */
inline constexpr double turn_limit = 90.0 / 180.0 * 3.14159265358979323846;

/** \brief A cloud with the size constraint to mesh it under (0: automatic). */
struct DeWallCase {
  std::string name;
  Cloud cloud;
  double length = 0;
};

/** \brief Every synthetic cloud, small enough to check each mesh by brute force. */
const std::vector<DeWallCase>&
syntheticCases();

/** \brief How a run is made; what is not set stays at its default. */
struct DeWallRun {
  DeWallRule rule = DeWallRule::Paper;
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

/** \brief As above with a leaf size of the kernel's divide step, so that small clouds get
 * walls, too. */
DeWallResult
triangulateInLeaves(const Cloud& cloud, const DeWallRun& run, std::int32_t leaf_size);

/** \brief Counts the faults against what the rule guarantees. */
testing::AssertionResult
keepsGuarantees(const DeWallResult& result, const DeWallRun& run);

/** \brief Triangles as sorted sets of corners, sorted: what is left when order and
 * rotation do not matter. */
Triangles
asSets(Triangles triangles);

/** \brief As above, after renaming corner i to names[i]. */
Triangles
asSets(const Triangles& triangles, const std::vector<std::int32_t>& names);

std::string
nameOf(DeWallRule rule);

} // namespace pcl::acmap::test
