#pragma once

#include "variant.h"

#include <cstdint>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief The tight boxes of up to eight siblings of the tree, axis by axis. */
struct alignas(32) SiblingBoxes {
  float low[3][8], high[3][8];
};

/** \brief The region of space of a group of siblings, between the splitting planes. The
 * fourth numbers are infinite. */
struct alignas(32) CellBox {
  float low[4], high[4];
};

/** \brief A PointTree as plain arrays, for kernels that must not use Eigen.
 *
 * The tree is complete: it has 2^depth leaves, and leaf l begins at point l n /
 * 2^depth. Eight leaves form a group of level 1, eight of these form one of level 2,
 * and so on; the single group of the highest level may have fewer members. */
struct TreeCells {
  static constexpr int leaf_capacity = 16;
  static constexpr int max_levels = 10;

  const float* coordinates[3] = {}; ///< in tree order, followed by zeros for a leaf
  std::int64_t points = 0;
  int depth = 0;
  int levels = 0;
  const SiblingBoxes* boxes[max_levels + 1] = {}; ///< of each group, by level
  const CellBox* cells[max_levels + 1] = {};      ///< of each group, by level
  unsigned members[max_levels + 1] = {}; ///< a bit for each member of a group, by level
};

static inline std::int32_t
firstOfLeaf(const TreeCells& tree, std::int32_t leaf)
{
  return static_cast<std::int32_t>((leaf * tree.points) >> tree.depth);
}

} // namespace pcl::acmap::ACMAP_DEWALL
