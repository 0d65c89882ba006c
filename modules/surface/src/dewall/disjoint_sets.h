#pragma once

#include "variant.h"

#include <pcl/core/scratch_memory.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief Union-find over indices; the lowest index of a set is its root. */
class DisjointSets {
public:
  explicit DisjointSets(std::int32_t size)
  : parent_(static_cast<std::size_t>(size))
  {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  std::int32_t
  find(std::int32_t i)
  {
    while (parent(i) != i)
      i = parent(i) = parent(parent(i));
    return i;
  }

  void
  unite(std::int32_t i, std::int32_t j)
  {
    i = find(i);
    j = find(j);
    parent(std::max(i, j)) = std::min(i, j);
  }

  /** \brief Number of sets, including those of one index. */
  std::size_t
  count()
  {
    std::size_t sets = 0;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(parent_.size()); ++i)
      sets += parent(i) == i;
    return sets;
  }

private:
  std::int32_t&
  parent(std::int32_t i)
  {
    return parent_[static_cast<std::size_t>(i)];
  }

  LargeVector<std::int32_t> parent_;
};

} // namespace pcl::acmap::ACMAP_DEWALL
