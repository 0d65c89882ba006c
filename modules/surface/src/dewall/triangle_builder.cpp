#include "triangle_builder.h"

#include "nearest.h"

namespace pcl::acmap::dewall {

namespace {

/** \brief Points within reach of alpha, the nearest first. */
std::vector<std::int32_t>
pointsNearPlane(const PointTree& tree, const PointTree::Node& node, const Front& front)
{
  const float* value = tree.coordinates(node.axis);
  const auto axis = static_cast<std::size_t>(node.axis);
  const float low = tree.node(node.left).high[axis],
              high = tree.node(node.right).low[axis];
  const double alpha = 0.5 * (static_cast<double>(low) + static_cast<double>(high));
  std::vector<std::pair<double, std::int32_t>> near;
  for (std::int32_t i = node.begin; i < node.end; ++i) {
    const double distance = std::abs(static_cast<double>(value[i]) - alpha);
    if (distance <= front.reachOf(i))
      near.emplace_back(distance, i);
  }
  std::sort(near.begin(), near.end());
  std::vector<std::int32_t> result;
  result.reserve(near.size());
  for (const auto& entry : near)
    result.push_back(entry.second);
  return result;
}

/** \brief Starts a component at every sheet that crosses alpha. */
void
seedWall(const PointTree& tree,
         const PointTree::Node& node,
         GrowingMesh& mesh,
         Front& front,
         const Range& range)
{
  for (const std::int32_t p1 : pointsNearPlane(tree, node, front)) {
    if (mesh.isUsed(p1))
      continue;
    const std::int32_t p2 =
        nearestPoint(tree, p1, front.reachOf(p1), [&](std::int32_t i) {
          return range.contains(i) && range.isCut({p1, i}) && !mesh.isUsed(i);
        });
    if (p2 >= 0)
      front.startAt(p1, p2, range);
  }
}

/** \brief Starts a component at every point left over in a leaf of the recursion. */
void
seedLeaf(const PointTree& tree, GrowingMesh& mesh, Front& front, const Range& range)
{
  for (std::int32_t p1 = range.begin; p1 < range.end; ++p1) {
    if (mesh.isUsed(p1))
      continue;
    const std::int32_t p2 =
        nearestPoint(tree, p1, front.reachOf(p1), [&](std::int32_t i) {
          return range.contains(i) && !mesh.isUsed(i);
        });
    if (p2 >= 0)
      front.startAt(p1, p2, range);
  }
}

} // namespace

void
buildTriangles(const PointTree& tree,
               GrowingMesh& mesh,
               Front& front,
               std::int32_t index,
               const std::vector<Side>& sides,
               std::uint8_t depth,
               std::int32_t leaf_size)
{
  const PointTree::Node& node = tree.node(index);
  const bool is_leaf = node.isLeaf() || node.size() <= leaf_size;
  const std::int32_t middle = is_leaf ? node.begin : tree.node(node.left).end;
  const Range range{node.begin, node.end, middle, depth};
  for (const Side& side : sides)
    front.insert(side, range);
  front.advance(range);
  if (is_leaf) {
    seedLeaf(tree, mesh, front, range);
    front.advancePostponed(range);
    return;
  }
  seedWall(tree, node, mesh, front, range);
  front.deferPostponed();
  std::vector<Side> left, right;
  for (const Side& side : front.takeUncut())
    (side.a < middle ? left : right).push_back(side);
  buildTriangles(tree, mesh, front, node.left, left, depth + 1, leaf_size);
  buildTriangles(tree, mesh, front, node.right, right, depth + 1, leaf_size);
}

} // namespace pcl::acmap::dewall
