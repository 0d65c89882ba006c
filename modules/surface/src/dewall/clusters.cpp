#include "mesh_steps.h"

#include "ball_visit.h"

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

/** \brief Connects points within and between leaves; pairs that are already connected
 * are skipped. */
class Clustering {
public:
  Clustering(const PointTree& tree, const SizeConstraint& size, PointSets connected)
  : tree_(tree)
  , size_(size)
  , sets_(std::move(connected))
  , is_one_set_(static_cast<std::size_t>(tree.leafCount()))
  , has_searched_(static_cast<std::size_t>(tree.leafCount()))
  {
    // Of two sets, at least one is not the largest; this one searches for the other.
    const std::int32_t largest = memberOfLargest();
    for (std::int32_t leaf = 0; leaf < tree.leafCount(); ++leaf)
      if (!isWithin(leaf, largest)) {
        join(leaf, leaf);
        joinNeighbours(leaf);
        has_searched_[static_cast<std::size_t>(leaf)] = true;
      }
  }

  PointSets
  takeSets()
  {
    return std::move(sets_);
  }

private:
  std::int32_t
  memberOfLargest()
  {
    LargeVector<std::int32_t> members(static_cast<std::size_t>(tree_.size()));
    PollPace pace;
    for (std::int32_t i = 0; i < tree_.size(); ++i) {
      pace();
      ++members[static_cast<std::size_t>(sets_.find(i))];
    }
    return static_cast<std::int32_t>(std::max_element(members.begin(), members.end()) -
                                     members.begin());
  }

  bool
  isWithin(std::int32_t leaf, std::int32_t member)
  {
    return sets_.find(tree_.firstOfLeaf(leaf)) == sets_.find(member) && isOneSet(leaf);
  }

  /** \brief Are all points of a leaf connected? Once they are, they remain so. */
  bool
  isOneSet(std::int32_t leaf)
  {
    if (is_one_set_[static_cast<std::size_t>(leaf)])
      return true;
    const std::int32_t begin = tree_.firstOfLeaf(leaf);
    const std::int32_t first = sets_.find(begin);
    for (std::int32_t i = begin + 1; i < tree_.firstOfLeaf(leaf + 1); ++i)
      if (sets_.find(i) != first)
        return false;
    return is_one_set_[static_cast<std::size_t>(leaf)] = true;
  }

  /** \brief Sets of the points of a leaf, so that pairs of points need not be looked up.
   */
  struct LeafSets {
    LeafSets(const PointTree& tree, std::int32_t leaf, PointSets& sets)
    : first(tree.firstOfLeaf(leaf))
    , count(tree.firstOfLeaf(leaf + 1) - first)
    {
      for (std::int32_t i = 0; i < count; ++i)
        of[static_cast<std::size_t>(i)] = sets.find(first + i);
    }

    std::int32_t
    operator[](std::int32_t i) const
    {
      return of[static_cast<std::size_t>(i)];
    }

    void
    rename(std::int32_t before, std::int32_t after)
    {
      std::replace(of.begin(), of.begin() + count, before, after);
    }

    std::int32_t first, count;
    std::array<std::int32_t, PointTree::leaf_capacity> of;
  };

  void
  join(std::int32_t one, std::int32_t other)
  {
    const double longest =
        std::min(size_.longestInLeaf(one), size_.longestInLeaf(other));
    const double limit = longest * longest;
    const Eigen::AlignedBox3d box = tree_.boxOfLeaf(other).cast<double>();
    if (box.squaredExteriorDistance(tree_.boxOfLeaf(one).cast<double>()) > limit)
      return;
    LeafSets ours(tree_, one, sets_);
    LeafSets theirs(tree_, other, sets_);
    for (std::int32_t i = 0; i < ours.count; ++i) {
      const Eigen::Vector3d p = tree_.position(ours.first + i);
      if (box.squaredExteriorDistance(p) > limit)
        continue;
      for (std::int32_t j = 0; j < theirs.count; ++j)
        if (ours[i] != theirs[j] &&
            (p - tree_.position(theirs.first + j)).squaredNorm() <= limit)
          unite(ours, i, theirs, j);
    }
  }

  void
  unite(LeafSets& ours, std::int32_t i, LeafSets& theirs, std::int32_t j)
  {
    sets_.unite(ours.first + i, theirs.first + j);
    const std::int32_t first = ours[i], second = theirs[j];
    const std::int32_t joined = sets_.find(ours.first + i);
    for (LeafSets* sets : {&ours, &theirs}) {
      sets->rename(first, joined);
      sets->rename(second, joined);
    }
  }

  void
  joinNeighbours(std::int32_t leaf)
  {
    const Eigen::AlignedBox3d box = tree_.boxOfLeaf(leaf).cast<double>();
    const double radius = box.diagonal().norm() / 2 + size_.longestInLeaf(leaf);
    const std::int32_t own = tree_.firstOfLeaf(leaf);
    const auto visit = [&](std::int32_t other, std::int32_t first, std::int32_t) {
      if (other == leaf || has_searched_[static_cast<std::size_t>(other)])
        return;
      const bool joined =
          sets_.find(first) == sets_.find(own) && isOneSet(leaf) && isOneSet(other);
      if (!joined)
        join(leaf, other);
    };
    visitBall(tree_, own, box.center(), radius, visit);
  }

  const PointTree& tree_;
  const SizeConstraint& size_;
  PointSets sets_;
  std::vector<bool> is_one_set_;   ///< for each leaf
  std::vector<bool> has_searched_; ///< for each leaf; it found its neighbours by itself
};

} // namespace

PointSets
findClusters(const PointTree& tree, const SizeConstraint& size, PointSets connected)
{
  return Clustering(tree, size, std::move(connected)).takeSets();
}

LargeVector<std::int32_t>
clusterSizes(PointSets& clusters, std::int32_t points)
{
  LargeVector<std::int32_t> sizes(static_cast<std::size_t>(points));
  PollPace pace;
  for (std::int32_t i = 0; i < points; ++i) {
    pace();
    ++sizes[static_cast<std::size_t>(clusters.find(i))];
  }
  return sizes;
}

std::size_t
countClusters(const PointTree& tree, const SizeConstraint& size, PointSets connected)
{
  PointSets clusters = findClusters(tree, size, std::move(connected));
  const LargeVector<std::int32_t> sizes = clusterSizes(clusters, tree.size());
  return static_cast<std::size_t>(std::count_if(
      sizes.begin(), sizes.end(), [](auto n) { return n >= min_cluster; }));
}

} // namespace pcl::acmap::ACMAP_DEWALL
