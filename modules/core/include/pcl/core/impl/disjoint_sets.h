#pragma once

#include <pcl/core/scratch_memory.h>

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace pcl::acmap {

/** \brief Union-find over indices from 0; the lowest index of a set is its root. */
template <typename Index>
class DisjointSets {
public:
  explicit DisjointSets(Index size)
  : parent_(static_cast<std::size_t>(size))
  {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  Index
  find(Index i)
  {
    while (parent(i) != i)
      i = parent(i) = parent(parent(i));
    return i;
  }

  void
  unite(Index i, Index j)
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
    for (Index i = 0; i < static_cast<Index>(parent_.size()); ++i)
      sets += parent(i) == i;
    return sets;
  }

private:
  Index&
  parent(Index i)
  {
    return parent_[static_cast<std::size_t>(i)];
  }

  LargeVector<Index> parent_;
};

} // namespace pcl::acmap
