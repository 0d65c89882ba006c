#include "clusters.h"

#include "disjoint_sets.h"

namespace pcl::acmap::dewall {

namespace {

/** \brief Joins points by triangles, then across and within leaves, looking at no pair
 * that is joined. */
class Clustering {
public:
  Clustering(const PointTree& tree,
             const SizeConstraint& size,
             const std::vector<GrownTriangle>& triangles)
  : tree_(tree)
  , size_(size)
  , sets_(tree.size())
  , is_one_set_(static_cast<std::size_t>(tree.size()))
  {
    for (const GrownTriangle& triangle : triangles) {
      sets_.unite(triangle.corners[0], triangle.corners[1]);
      sets_.unite(triangle.corners[0], triangle.corners[2]);
    }
    // Of two sets one at least is not the largest: that one looks for the other.
    const std::int32_t largest = memberOfLargest();
    for (std::int32_t n = 0; n < tree.nodeCount(); ++n)
      if (tree.node(n).isLeaf() && !isWithin(tree.node(n), largest)) {
        join(tree.node(n), tree.node(n));
        joinNeighbours(tree.node(n));
      }
  }

  DisjointSets&
  sets()
  {
    return sets_;
  }

private:
  std::int32_t
  memberOfLargest()
  {
    std::vector<std::int32_t> members(static_cast<std::size_t>(tree_.size()));
    for (std::int32_t i = 0; i < tree_.size(); ++i)
      ++members[static_cast<std::size_t>(sets_.find(i))];
    return static_cast<std::int32_t>(std::max_element(members.begin(), members.end()) -
                                     members.begin());
  }

  bool
  isWithin(const PointTree::Node& leaf, std::int32_t member)
  {
    return sets_.find(leaf.begin) == sets_.find(member) && isOneSet(leaf);
  }

  /** \brief Are all points of a leaf joined? Once they are they stay so. */
  bool
  isOneSet(const PointTree::Node& leaf)
  {
    if (is_one_set_[static_cast<std::size_t>(leaf.begin)])
      return true;
    const std::int32_t first = sets_.find(leaf.begin);
    for (std::int32_t i = leaf.begin + 1; i < leaf.end; ++i)
      if (sets_.find(i) != first)
        return false;
    return is_one_set_[static_cast<std::size_t>(leaf.begin)] = true;
  }

  void
  join(const PointTree::Node& one, const PointTree::Node& other)
  {
    for (std::int32_t i = one.begin; i < one.end; ++i)
      for (std::int32_t j = other.begin; j < other.end; ++j)
        if (sets_.find(i) != sets_.find(j) &&
            size_.allows(i, j, (tree_.position(i) - tree_.position(j)).squaredNorm()))
          sets_.unite(i, j);
  }

  void
  joinNeighbours(const PointTree::Node& leaf)
  {
    const Eigen::Vector3d low = Eigen::Vector3f(leaf.low.data()).cast<double>();
    const Eigen::Vector3d high = Eigen::Vector3f(leaf.high.data()).cast<double>();
    const double radius = (high - low).norm() / 2 + size_.longestInLeaf(leaf);
    const auto visit = [&](const PointTree::Node& other) {
      if (other.begin == leaf.begin)
        return;
      const bool joined = sets_.find(other.begin) == sets_.find(leaf.begin) &&
                          isOneSet(leaf) && isOneSet(other);
      if (!joined)
        join(leaf, other);
    };
    tree_.visitBall(
        leaf.begin,
        (low + high) / 2,
        radius,
        [](const PointTree::Node&) { return true; },
        visit);
  }

  const PointTree& tree_;
  const SizeConstraint& size_;
  DisjointSets sets_;
  std::vector<bool> is_one_set_; ///< by the first point of a leaf
};

} // namespace

std::size_t
countClusters(const PointTree& tree,
              const SizeConstraint& size,
              const std::vector<GrownTriangle>& triangles)
{
  Clustering clustering(tree, size, triangles);
  std::vector<std::int32_t> members(static_cast<std::size_t>(tree.size()));
  for (std::int32_t i = 0; i < tree.size(); ++i)
    ++members[static_cast<std::size_t>(clustering.sets().find(i))];
  return static_cast<std::size_t>(
      std::count_if(members.begin(), members.end(), [](auto n) { return n >= 3; }));
}

} // namespace pcl::acmap::dewall
