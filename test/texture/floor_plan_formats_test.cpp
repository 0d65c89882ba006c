#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/texture/floor_plan.h>

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <ogrsf_frmts.h>

#include <map>
#include <memory>
#include <string>
#include <tuple>

namespace pcl::acmap::test {
namespace {

using Eigen::Vector2d;

/** A room of 4 x 3 m with a hole in its floor, a door and a window. */
FloorPlan
planOfARoom()
{
  FloorPlan plan;
  const Vector2d corners[] = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  plan.floors = {{{corners[0], corners[1], corners[2], corners[3]},
                  {{1, 1}, {1, 2}, {2, 2}, {2, 1.0005}}}};
  for (std::size_t i = 0; i < 4; ++i) {
    PlanWall wall;
    wall.from = corners[i];
    wall.to = corners[(i + 1) % 4];
    wall.plane = 10 + i;
    plan.walls.push_back(wall);
  }
  plan.openings.resize(2);
  plan.openings[0].from = {1, 0};
  plan.openings[0].to = {1.9, 0};
  plan.openings[0].rooms = {0, -1};
  plan.openings[1].is_window = true;
  plan.openings[1].from = {4, 1};
  plan.openings[1].to = {4, 2};
  plan.openings[1].top = 2.1;
  plan.rooms.resize(1);
  plan.rooms[0].center = {2, 2.5};
  plan.rooms[0].area = 12;
  return plan;
}

/** The features of a file as GDAL reads them, by the value of a field. */
std::map<std::string, std::vector<std::unique_ptr<OGRFeature>>>
readByGdal(const std::string& path, const char* field)
{
  GDALAllRegister();
  std::map<std::string, std::vector<std::unique_ptr<OGRFeature>>> features;
  const GDALDatasetUniquePtr file(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
  EXPECT_NE(file, nullptr) << path;
  if (!file)
    return features;
  for (auto&& layer : file->GetLayers())
    for (auto&& feature : *layer)
      features[feature->GetFieldAsString(field)].emplace_back(feature->Clone());
  return features;
}

void
expectLine(const OGRFeature& feature, const Vector2d& from, const Vector2d& to)
{
  const OGRGeometry* const geometry = feature.GetGeometryRef();
  ASSERT_EQ(wkbFlatten(geometry->getGeometryType()), wkbLineString);
  const OGRLineString* const line = geometry->toLineString();
  ASSERT_EQ(line->getNumPoints(), 2);
  EXPECT_LT((Vector2d(line->getX(0), line->getY(0)) - from).norm(), 1e-6);
  EXPECT_LT((Vector2d(line->getX(1), line->getY(1)) - to).norm(), 1e-6);
}

TEST(FloorPlanFormats, ADrawingIsReadByGdal)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("plan.dxf");
  const FloorPlan plan = planOfARoom();
  saveFloorPlan(path, plan);
  const auto layers = readByGdal(path, "Layer");
  ASSERT_EQ(layers.size(), 6U);
  EXPECT_EQ(layers.at("FLOOR").size(), 2U);
  ASSERT_EQ(layers.at("WALLS").size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
    expectLine(*layers.at("WALLS")[i], plan.walls[i].from, plan.walls[i].to);
  ASSERT_EQ(layers.at("DOORS").size(), 1U);
  expectLine(*layers.at("DOORS")[0], plan.openings[0].from, plan.openings[0].to);
  ASSERT_EQ(layers.at("WINDOWS").size(), 1U);
  EXPECT_STREQ(layers.at("ROOMS").at(0)->GetFieldAsString("Text"), "12.0 m2");
  EXPECT_EQ(layers.at("NORTH").size(), 2U);
}

TEST(FloorPlanFormats, FeaturesAreReadByGdal)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("plan.geojson");
  const FloorPlan plan = planOfARoom();
  saveFloorPlan(path, plan);
  const auto kinds = readByGdal(path, "kind");
  ASSERT_EQ(kinds.size(), 5U);
  ASSERT_EQ(kinds.at("wall").size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    expectLine(*kinds.at("wall")[i], plan.walls[i].from, plan.walls[i].to);
    EXPECT_EQ(kinds.at("wall")[i]->GetFieldAsInteger("plane"),
              10 + static_cast<int>(i));
  }
  ASSERT_EQ(kinds.at("floor").size(), 1U);
  const OGRGeometry* const floor = kinds.at("floor")[0]->GetGeometryRef();
  EXPECT_NEAR(floor->toPolygon()->get_Area(), 12 - 0.99975, 1e-6);
  EXPECT_TRUE(
      kinds.at("door")[0]->IsFieldNull(kinds.at("door")[0]->GetFieldIndex("top")));
  EXPECT_EQ(kinds.at("window")[0]->GetFieldAsDouble("top"), 2.1);
  EXPECT_EQ(kinds.at("room")[0]->GetFieldAsDouble("area"), 12);
}

TEST(FloorPlanFormats, PlacesOfANationalGridComeBack)
{
  const TemporaryFolder folder;
  FloorPlan plan = planOfARoom();
  plan.y_axis = Eigen::Vector3d::UnitY();
  plan.up = Eigen::Vector3d::UnitZ();
  plan.shift << 452000, 5411000, 300;
  const Vector2d offset(452000, 5411000);
  for (const auto& [name, field, kind] :
       {std::tuple("plan.dxf", "Layer", "WALLS"), {"plan.geojson", "kind", "wall"}}) {
    saveFloorPlan(folder.path(name), plan);
    const auto features = readByGdal(folder.path(name), field);
    ASSERT_EQ(features.at(kind).size(), 4U);
    for (std::size_t i = 0; i < 4; ++i)
      expectLine(*features.at(kind)[i],
                 plan.walls[i].from + offset,
                 plan.walls[i].to + offset);
  }
  saveFloorPlan(folder.path("plan.svg"), plan);
  EXPECT_THAT(contentOf(folder.path("plan.svg")),
              testing::HasSubstr("is at 452000.000 5411000.000</desc>"));
}

TEST(FloorPlanFormats, AnEmptyPlanIsReadable)
{
  const TemporaryFolder folder;
  saveFloorPlan(folder.path("plan.dxf"), {});
  EXPECT_EQ(readByGdal(folder.path("plan.dxf"), "Layer").size(), 1U) << "its north";
  saveFloorPlan(folder.path("plan.geojson"), {});
  EXPECT_TRUE(readByGdal(folder.path("plan.geojson"), "kind").empty());
  EXPECT_THROW(saveFloorPlan(folder.path("plan.pdf"), {}), BadArgumentException);
  EXPECT_THROW(saveFloorPlan(folder.path("none/plan.dxf"), {}), OutputFileException);
}

} // namespace
} // namespace pcl::acmap::test
