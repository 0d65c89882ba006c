#include "clouds.h"
#include "dewall/mesh_steps.h"
#include "tested_variant.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace pcl::acmap::test {
namespace {

using namespace ACMAP_DEWALL;

class EdgesAndFans : public VariantTest {};

std::unique_ptr<PointTree>
treeOfRing(std::int32_t points)
{
  SourcePoints all{{{0, 0, 0}, 0}};
  for (std::int32_t i = 1; i < points; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / points;
    all.push_back({{static_cast<float>(std::cos(angle)),
                    static_cast<float>(std::sin(angle)),
                    0.1F},
                   i});
  }
  return std::make_unique<PointTree>(std::move(all));
}

std::vector<std::int32_t>
higherEnds(MeshArrays& arrays, std::int32_t low)
{
  std::vector<std::int32_t> ends;
  arrays.forEachEdgeAt(low,
                       [&](const Edge&, std::int32_t high) { ends.push_back(high); });
  return ends;
}

/** Edges are added and removed at random; a list per vertex tells what has to be there,
 * the last edge first. */
TEST_F(EdgesAndFans, edgesAreThoseOfAPlainList)
{
  constexpr std::int32_t points = 40;
  const auto tree = treeOfRing(points);
  const Facing facing;
  MeshArrays arrays(*tree, facing);
  EdgePool::Cursor memory(arrays.edges);
  std::vector<std::vector<std::int32_t>> expected(points);
  Random random(5);
  const auto pick = [&] { return static_cast<std::int32_t>(random.bits() % points); };
  std::size_t longest = 0;
  for (int step = 0; step < 20000; ++step) {
    const std::int32_t a = pick() % 6, b = pick(); // long lists at few vertices
    if (a == b)
      continue;
    const std::int32_t low = std::min(a, b), high = std::max(a, b);
    std::vector<std::int32_t>& list = expected[static_cast<std::size_t>(low)];
    const auto place = std::find(list.begin(), list.end(), high);
    Edge* found = arrays.find(a, b);
    ASSERT_EQ(found != nullptr, place != list.end());
    if (found) {
      EXPECT_EQ(found->opposites, 100 * low + high);
      arrays.removeEdge(a, b, memory);
      list.erase(place);
    }
    else {
      arrays.addEdge(a, b, memory).opposites = 100 * low + high;
      list.insert(list.begin(), high);
    }
    ASSERT_EQ(higherEnds(arrays, low), list);
    longest = std::max(longest, list.size());
  }
  EXPECT_GT(longest, 12U); // beyond the second entry of the pool
}

/** A fan around point \a hub over consecutive points of the ring. */
void
addFan(GrowingMesh& mesh, std::int32_t hub, const std::vector<std::int32_t>& ring)
{
  mesh.addSeed({hub, ring[0], ring[1]});
  for (std::size_t i = 2; i < ring.size(); ++i) {
    const Side side = mesh.asItRuns({hub, ring[i - 1]});
    mesh.add(mesh.propose(side, ring[i]));
  }
}

std::vector<std::int32_t>
treePoints(const PointTree& tree, std::int32_t first_source, std::int32_t end_source)
{
  std::vector<std::int32_t> points;
  for (std::int32_t source = first_source; source < end_source; ++source)
    for (std::int32_t i = 0; i < tree.size(); ++i)
      if (tree.source(i) == source)
        points.push_back(i);
  return points;
}

/** With fewer and with more triangles at the vertex than a word has bits. */
TEST_F(EdgesAndFans, theLargestFanIsKept)
{
  for (const std::int32_t size : {6, 30, 63, 64, 65, 150})
    for (const bool is_large_first : {true, false}) {
      const auto tree = treeOfRing(2 * size + 3);
      const Facing facing;
      MeshArrays arrays(*tree, facing);
      GrowingMesh mesh(arrays, {});
      const std::int32_t hub = treePoints(*tree, 0, 1).front();
      const auto large = treePoints(*tree, 1, size + 2);
      const auto small = treePoints(*tree, size + 2, 2 * size + 2);
      addFan(mesh, hub, is_large_first ? large : small);
      addFan(mesh, hub, is_large_first ? small : large);
      const auto removed = keepLargestFans(mesh, {&mesh.triangles()}, false);
      EXPECT_EQ(removed.size(), small.size() - 1);
      EXPECT_EQ(mesh.triangles().size(), large.size() - 1);
      for (const GrownTriangle& triangle : mesh.triangles())
        for (const std::int32_t corner : triangle.corners)
          EXPECT_TRUE(corner == hub ||
                      std::find(large.begin(), large.end(), corner) != large.end());
      EXPECT_EQ(arrays.vertex(hub).open_edges, 2);
    }
}

/** Of two fans of the same size, the one of the earlier triangle is kept. */
TEST_F(EdgesAndFans, theEarlierOfEqualFansIsKept)
{
  const auto tree = treeOfRing(13);
  const Facing facing;
  MeshArrays arrays(*tree, facing);
  GrowingMesh mesh(arrays, {});
  const std::int32_t hub = treePoints(*tree, 0, 1).front();
  const auto first = treePoints(*tree, 7, 11), second = treePoints(*tree, 1, 5);
  addFan(mesh, hub, first);
  addFan(mesh, hub, second);
  keepLargestFans(mesh, {&mesh.triangles()}, false);
  for (const GrownTriangle& triangle : mesh.triangles())
    for (const std::int32_t corner : triangle.corners)
      EXPECT_EQ(std::count(second.begin(), second.end(), corner), 0);
}

/** An edge that loses its first triangle runs as its other one does. */
TEST_F(EdgesAndFans, openEdgesRunAsTheirTriangle)
{
  const auto tree = treeOfRing(8);
  const Facing facing;
  MeshArrays arrays(*tree, facing);
  GrowingMesh mesh(arrays, {});
  const std::int32_t hub = treePoints(*tree, 0, 1).front();
  const auto ring = treePoints(*tree, 1, 6);
  addFan(mesh, hub, ring);
  mesh.takeOut(mesh.triangles()[0]);
  mesh.takeOut(mesh.triangles()[2]);
  mesh.sweep({&mesh.triangles()});
  ASSERT_EQ(mesh.triangles().size(), 2U);
  for (const GrownTriangle& triangle : mesh.triangles())
    for (const Side& side : sidesOf(triangle)) {
      ASSERT_TRUE(mesh.findOpen(side));
      const Side runs = mesh.asItRuns({side.b, side.a});
      EXPECT_EQ(runs.a, side.a);
      EXPECT_EQ(runs.b, side.b);
      EXPECT_EQ(mesh.findOpen(side)->componentNumber(), triangle.component);
    }
}

} // namespace
} // namespace pcl::acmap::test
