#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap::texturing {

/** Chooses for each of some nodes whether it stays or moves, such that the sum of the costs is as
 * small as possible: a minimum cut, by the maximum flow of Boykov and Kolmogorov. Where the costs
 * of a pair are not submodular, they are approximated. */
class MinimumCut {
public:
  explicit MinimumCut(std::size_t nodes);

  /** Adds to the costs of a node. */
  void
  add(std::size_t node, std::int64_t stays, std::int64_t moves);

  /** Adds to the costs of two nodes: both stay, the second moves, the first moves, both do. */
  void
  addPair(std::size_t first,
          std::size_t second,
          std::int64_t stay,
          std::int64_t second_moves,
          std::int64_t first_moves,
          std::int64_t move);

  /** \return which nodes move */
  std::vector<bool>
  solve();

private:
  struct Pair {
    std::size_t first, second;
    std::int64_t cost; ///< if the first stays and the second moves
  };

  std::vector<std::int64_t> of_moving_; ///< less what staying costs, of each node
  std::vector<Pair> pairs_;
};

} // namespace pcl::acmap::texturing
