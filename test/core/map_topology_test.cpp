#include "json_file.h"
#include "messages.h"
#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/map_file.h>
#include <pcl/core/map_topology.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;
using Planes = std::array<std::int32_t, 2>;

/** Floor and wall that share the edge from (0, 0, 0) to (2, 0, 0); the wall has a hole. */
std::vector<PlanePatch>
makeFloorAndWall()
{
  std::vector<PlanePatch> planes(2);
  planes[0].coefficients = {0, 0, 1, 0};
  planes[0].polygons = {{{{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}}, {}}};
  planes[0].polygons[0].edges = {{EdgeKind::Crease, 1},
                                 {EdgeKind::Frontier, -1},
                                 {EdgeKind::Frontier, -1},
                                 {EdgeKind::Rim, -1}};
  planes[1].coefficients = {0, 1, 0, 0};
  planes[1].polygons = {{{{0, 0, 0}, {0, 0, 2}, {2, 0, 2}, {2, 0, 0}},
                         {{{1, 0, 1}, {1, 0, 1.5F}, {0.5F, 0, 1}}}}};
  planes[1].polygons[0].edges.assign(7, {EdgeKind::Rim, -1});
  planes[1].polygons[0].edges[3] = {EdgeKind::Crease, 0};
  planes[1].polygons[0].edges[0] = {EdgeKind::Contact, 0};
  return planes;
}

const MapEdge&
edgeOf(const MapTopology& topology, const Planes& vertices)
{
  return *std::find_if(topology.edges.begin(),
                       topology.edges.end(),
                       [&](const auto& e) { return e.vertices == vertices; });
}

TEST(MapTopology, tellsWhatPolygonsHaveInCommonOnce)
{
  const MapTopology topology = topologyOf(makeFloorAndWall());
  EXPECT_EQ(topology.vertices.size(), 4U + 2 + 3);
  EXPECT_EQ(topology.edges.size(), 4U + 3 + 3);
  ASSERT_EQ(topology.faces.size(), 2U);
  EXPECT_EQ(topology.faces[1].outer, (std::vector<std::int32_t>{0, 4, 5, 1}));
  EXPECT_EQ(topology.faces[1].holes[0], (std::vector<std::int32_t>{6, 7, 8}));
  const MapEdge crease = edgeOf(topology, {0, 1});
  EXPECT_EQ(crease.kind, EdgeKind::Crease);
  EXPECT_EQ(crease.planes, (Planes{0, 1}));
  EXPECT_EQ(edgeOf(topology, {0, 3}).kind, EdgeKind::Rim);
  EXPECT_EQ(edgeOf(topology, {0, 4}).kind, EdgeKind::Contact);
  EXPECT_EQ(edgeOf(topology, {0, 4}).planes, (Planes{1, 0}));
}

TEST(MapTopology, equalEdgesAreCreasesThoughNothingIsTold)
{
  std::vector<PlanePatch> planes = makeFloorAndWall();
  for (PlanePatch& plane : planes)
    plane.polygons[0].edges.clear();
  const MapTopology topology = topologyOf(planes);
  EXPECT_EQ(edgeOf(topology, {0, 1}).kind, EdgeKind::Crease);
  EXPECT_EQ(edgeOf(topology, {1, 2}).kind, EdgeKind::Open);
}

TEST(MapTopology, creaseOfAPlaneThatIsGoneIsOpen)
{
  std::vector<PlanePatch> planes = makeFloorAndWall();
  planes.pop_back();
  const MapTopology topology = topologyOf(planes);
  EXPECT_EQ(edgeOf(topology, {0, 1}).kind, EdgeKind::Open);
  EXPECT_EQ(edgeOf(topology, {0, 1}).planes, (Planes{0, -1}));
  EXPECT_TRUE(topologyOf({}).vertices.empty());
  EXPECT_TRUE(topologyOf(std::vector<PlanePatch>(3)).faces.empty());
}

class TopologyFile : public testing::Test {
protected:
  TopologyFile()
  {
    map_.planes = makeFloorAndWall();
    saveMapFile(path_, map_);
  }

  std::string
  faultAt(const std::string& pointer, const nlohmann::json& value) const
  {
    auto json = jsonOfFile(path_);
    json.at(nlohmann::json::json_pointer(pointer)) = value;
    return messageOf<InputFileException>(
        [&] { loadMapFile(folder_.write("changed.json", json.dump())); }, "no fault");
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_.path("map.json");
  CompactMap map_;
};

TEST_F(TopologyFile, kindsComeBack)
{
  const std::vector<PlanePatch> back = loadMapFile(path_).planes;
  for (std::size_t p = 0; p < 2; ++p) {
    const auto& found = back[p].polygons[0].edges;
    const auto& wanted = map_.planes[p].polygons[0].edges;
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_EQ(found[i].kind, wanted[i].kind) << p << ", " << i;
      EXPECT_EQ(found[i].neighbour, wanted[i].neighbour) << p << ", " << i;
    }
  }
}

TEST_F(TopologyFile, liesAreNamed)
{
  EXPECT_THAT(faultAt("/vertices/2", {9, 9, 9}), HasSubstr("vertices[2]"));
  EXPECT_THAT(faultAt("/vertices", nlohmann::json::array()), HasSubstr("vertices"));
  EXPECT_THAT(faultAt("/edges/0/kind", "wall"), HasSubstr("edges[0].kind"));
  EXPECT_THAT(faultAt("/edges/0/vertices", {0, 99}), HasSubstr("edges[0].vertices[1]"));
  EXPECT_THAT(faultAt("/edges/0/planes", {0, 2}), HasSubstr("edges[0].planes[1]"));
  EXPECT_THAT(faultAt("/edges/0/planes", nlohmann::json::array()),
              HasSubstr("edges[0].planes"));
  EXPECT_THAT(faultAt("/edges", nlohmann::json::array()),
              HasSubstr("from vertex 0 to"));
}

TEST_F(TopologyFile, edgesMustBeAsManyAsPoints)
{
  map_.planes[0].polygons[0].edges.pop_back();
  EXPECT_THROW(saveMapFile(path_, map_), BadArgumentException);
}

} // namespace
} // namespace pcl::acmap::test
