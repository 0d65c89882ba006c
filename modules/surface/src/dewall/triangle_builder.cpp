#include "triangle_builder.h"

#include "mesh_steps.h"
#include "nearest.h"

#include <oneapi/tbb/parallel_invoke.h>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

/** \brief The leaves of the tree that are within the maximum edge length of alpha, the
 * nearest ones first. */
std::vector<std::int32_t>
leavesNearPlane(const PointTree& tree,
                const PointTree::Plane& alpha,
                const Range& range,
                const SizeConstraint& size)
{
  std::vector<std::pair<float, std::int32_t>> near;
  for (std::int32_t leaf = range.first_leaf; leaf < range.end_leaf; ++leaf) {
    const Eigen::AlignedBox3f box = tree.boxOfLeaf(leaf);
    const int axis = alpha.axis;
    const float distance = std::max(
        0.0f, std::max(box.min()[axis] - alpha.offset, alpha.offset - box.max()[axis]));
    if (static_cast<double>(distance) <= size.longestInLeaf(leaf))
      near.emplace_back(distance, leaf);
  }
  std::sort(near.begin(), near.end());
  std::vector<std::int32_t> leaves;
  leaves.reserve(near.size());
  for (const auto& entry : near)
    leaves.push_back(entry.second);
  return leaves;
}

/** \brief Grows the part of one node. */
class PartBuilder {
public:
  PartBuilder(Part& part,
              MeshArrays& arrays,
              const SizeConstraint& size,
              const BuilderSettings& settings,
              const std::function<void()>& tick,
              const ParityUnion& parity,
              bool is_wall)
  : part_(part)
  , tree_(arrays.tree)
  , size_(size)
  , settings_(settings)
  , tick_(tick)
  , range_(arrays.tree, part.node, is_wall)
  , mesh_(arrays, parity)
  , front_(arrays.tree, size, settings.rule, mesh_, tick)
  {
    mesh_.setOfWall(is_wall);
    part.first_component = parity.size();
  }

  /** \return the edges of each half (L_l and L_r) */
  std::array<std::vector<Side>, 2>
  growWall(const std::vector<Side>& sides)
  {
    for (const Side& side : sides)
      front_.insert(side, range_);
    front_.advance(range_);
    for (const std::int32_t leaf :
         leavesNearPlane(tree_, tree_.planeOf(part_.node), range_, size_))
      seedAt(leaf, 2); // the halves find what a wall misses
    front_.deferWaiting();
    std::array<std::vector<Side>, 2> halves;
    for (const Side& side : front_.takeUncut())
      halves[side.a < range_.middle ? 0 : 1].push_back(side);
    finish();
    return halves;
  }

  void
  growLeaf(const std::vector<Side>& sides)
  {
    for (const Side& side : sides)
      front_.insert(side, range_);
    front_.advance(range_);
    for (std::int32_t leaf = range_.first_leaf; leaf < range_.end_leaf; ++leaf)
      seedAt(leaf, PointTree::leaf_capacity);
    front_.advancePostponed(range_);
    front_.advanceContrary(range_);
    complete();
    finish();
  }

  ParityUnion&
  parity()
  {
    return mesh_.parity();
  }

private:
  /** \brief Starts a component in a leaf of the tree if many of its points are unused:
   * a few unused points below a noisy surface do not indicate another surface. */
  void
  seedAt(std::int32_t leaf, int trials)
  {
    const std::int32_t first = tree_.firstOfLeaf(leaf),
                       end = tree_.firstOfLeaf(leaf + 1);
    for (std::int32_t p1 = first; p1 < end; ++p1) {
      const int unused =
          __builtin_popcount(mesh_.arrays().unused[static_cast<std::size_t>(leaf)]);
      if (2 * unused < end - first)
        return;
      if (mesh_.isUsed(p1))
        continue;
      const std::int32_t p2 =
          nearestPoint(tree_, p1, size_.longest(p1), [&](std::int32_t i) {
            return range_.contains(i) && range_.isCut({p1, i}) && !mesh_.isUsed(i);
          });
      if (p2 >= 0)
        front_.startAt(p1, p2, range_);
      if (--trials == 0)
        return;
    }
  }

  /** \brief Performs the last passes as far as possible within the part. */
  void
  complete()
  {
    part_.removed_fans = keepLargestFans(mesh_, {&mesh_.triangles()}, false).size();
    Unfinished begun;
    for (const Side& side : mesh_.openSides(range_.begin, range_.end))
      if (range_.contains(side.a) && range_.contains(side.b))
        begun.sides.push_back(side);
    for (std::int32_t i = range_.begin; i < range_.end; ++i)
      if (!mesh_.isUsed(i))
        begun.points.push_back(i);
    part_.unfinished =
        Refill(size_, settings_.rule, mesh_, range_, tick_).run(std::move(begun));
    if (settings_.rule == DeWallRule::Dense)
      closeSmallHoles(size_, mesh_, range_);
  }

  void
  finish()
  {
    part_.triangles = mesh_.arrays().triangles.copyOf(mesh_.triangles());
    part_.components = mesh_.parity().size() - part_.first_component;
    part_.joints = mesh_.takeJoints();
    part_.deferred = front_.takeDeferred();
    part_.refused_moebius = mesh_.refusedMoebius();
  }

  Part& part_;
  const PointTree& tree_;
  const SizeConstraint& size_;
  const BuilderSettings& settings_;
  const std::function<void()>& tick_;
  const Range range_;
  GrowingMesh mesh_;
  Front front_;
};

class Recursion {
public:
  Recursion(MeshArrays& arrays,
            const SizeConstraint& size,
            const BuilderSettings& settings,
            const std::function<void()>& tick)
  : arrays_(arrays)
  , size_(size)
  , settings_(settings)
  , tick_(tick)
  {
    const std::int64_t points = arrays.tree.size();
    while (depth_ < arrays.tree.cells().depth &&
           ((points - 1) >> depth_) + 1 > settings.leaf_size)
      ++depth_;
    parts_.resize((std::size_t{2} << depth_) - 1);
    for (std::size_t i = 1; i < parts_.size(); ++i) {
      const PointTree::Node& parent = parts_[(i - 1) / 2].node;
      parts_[i].node = i % 2 == 1 ? parent.left() : parent.right();
    }
  }

  std::vector<Part>
  run()
  {
    build(0, {}, {});
    return std::move(parts_);
  }

private:
  void
  build(std::size_t index, const std::vector<Side>& sides, const ParityUnion& above)
  {
    Part& part = parts_[index];
    if (part.node.depth == depth_) {
      PartBuilder(part, arrays_, size_, settings_, tick_, above, false).growLeaf(sides);
      return;
    }
    std::array<std::vector<Side>, 2> halves;
    ParityUnion parity;
    {
      PartBuilder wall(part, arrays_, size_, settings_, tick_, above, true);
      halves = wall.growWall(sides);
      parity = std::move(wall.parity());
    }
    oneapi::tbb::parallel_invoke([&] { build(2 * index + 1, halves[0], parity); },
                                 [&] { build(2 * index + 2, halves[1], parity); });
  }

  MeshArrays& arrays_;
  const SizeConstraint& size_;
  const BuilderSettings& settings_;
  const std::function<void()>& tick_;
  int depth_ = 0; ///< depth of the leaves of the recursion
  std::vector<Part> parts_;
};

} // namespace

std::vector<Part>
buildTriangles(MeshArrays& arrays,
               const SizeConstraint& size,
               const BuilderSettings& settings,
               const std::function<void()>& tick)
{
  return Recursion(arrays, size, settings, tick).run();
}

} // namespace pcl::acmap::ACMAP_DEWALL
