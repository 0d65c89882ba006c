#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/texture/floor_plan.h>

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
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
  plan.rooms[0].outline = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
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

/** The lines between two points of a layer. */
std::vector<const OGRFeature*>
linesOf(const std::vector<std::unique_ptr<OGRFeature>>& features)
{
  std::vector<const OGRFeature*> lines;
  for (const auto& feature : features)
    if (const OGRGeometry* geometry = feature->GetGeometryRef();
        geometry && wkbFlatten(geometry->getGeometryType()) == wkbLineString &&
        geometry->toLineString()->getNumPoints() == 2)
      lines.push_back(feature.get());
  return lines;
}

TEST(FloorPlanFormats, ADrawingIsReadByGdal)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("plan.dxf");
  const FloorPlan plan = planOfARoom();
  saveFloorPlan(path, plan);
  const auto layers = readByGdal(path, "Layer");
  std::vector<std::string> names;
  for (const auto& layer : layers)
    names.push_back(layer.first);
  ASSERT_THAT(names,
              testing::ElementsAre("DIMENSIONS",
                                   "DOORS",
                                   "FLOOR",
                                   "NORTH",
                                   "ROOMS",
                                   "TITLE",
                                   "WALLS",
                                   "WINDOWS"))
      << "there is no furniture";
  EXPECT_EQ(layers.at("FLOOR").size(), 3U) << "and the outline of the room";
  const auto faces = linesOf(layers.at("WALLS"));
  ASSERT_EQ(faces.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
    expectLine(*faces[i], plan.walls[i].from, plan.walls[i].to);
  double filled = 0; // behind the faces, with the corners twice
  for (const auto& feature : layers.at("WALLS"))
    if (wkbFlatten(feature->GetGeometryRef()->getGeometryType()) == wkbPolygon)
      filled += feature->GetGeometryRef()->toPolygon()->get_Area();
  EXPECT_NEAR(filled, 0.08 * (14 + 4 * 0.08), 1e-6);
  // the leaf of the door, as long as the opening is wide
  const auto leaves = linesOf(layers.at("DOORS"));
  EXPECT_EQ(std::count_if(leaves.begin(),
                          leaves.end(),
                          [](const OGRFeature* line) {
                            const auto* ends = line->GetGeometryRef()->toLineString();
                            return std::abs(ends->getX(0) - ends->getX(1)) < 1e-6 &&
                                   std::abs(ends->get_Length() - 0.9) < 1e-6;
                          }),
            1);
  const auto textsOf = [&](const char* layer) {
    std::vector<std::string> texts;
    for (const auto& feature : layers.at(layer))
      texts.emplace_back(feature->GetFieldAsString("Text"));
    return texts;
  };
  using testing::Contains;
  EXPECT_THAT(textsOf("ROOMS"), testing::ElementsAre("Room 1", "12.0 m2"));
  EXPECT_THAT(textsOf("WINDOWS"), Contains("1.00 x 2.10"));
  EXPECT_THAT(textsOf("DIMENSIONS"), Contains("4.00"));
  EXPECT_THAT(textsOf("TITLE"), Contains("1 : 50 on A4, lengths in metres"));
  EXPECT_THAT(textsOf("NORTH"), Contains("z"));
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
    const auto lines = linesOf(features.at(kind));
    ASSERT_EQ(lines.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i)
      expectLine(*lines[i], plan.walls[i].from + offset, plan.walls[i].to + offset);
  }
  saveFloorPlan(folder.path("plan.svg"), plan);
  EXPECT_THAT(contentOf(folder.path("plan.svg")),
              testing::HasSubstr("is at 452000.000 5411000.000</desc>"));
}

TEST(FloorPlanFormats, AnEmptyPlanIsReadable)
{
  const TemporaryFolder folder;
  saveFloorPlan(folder.path("plan.dxf"), {});
  EXPECT_EQ(readByGdal(folder.path("plan.dxf"), "Layer").size(), 2U)
      << "its north and its title";
  saveFloorPlan(folder.path("plan.geojson"), {});
  EXPECT_TRUE(readByGdal(folder.path("plan.geojson"), "kind").empty());
  EXPECT_THROW(saveFloorPlan(folder.path("plan.pdf"), {}), BadArgumentException);
  EXPECT_THROW(saveFloorPlan(folder.path("none/plan.dxf"), {}), OutputFileException);
}

} // namespace
} // namespace pcl::acmap::test
