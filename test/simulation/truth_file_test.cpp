#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/simulation/merged_rows.h>
#include <pcl/simulation/repeated_scene.h>
#include <pcl/simulation/standard_scenes.h>
#include <pcl/simulation/truth_file.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace pcl::acmap::test {
namespace {

using Json = nlohmann::json;

TEST(TruthFile, CountsWhatActiveStereoCanMeasure)
{
  const SimulatedScene scene = standardScene("room");
  const SimulatedTruth truth = truthOf(scene, 0);
  const std::size_t planes = scene.geometry.planes().size();
  TruthPoints all(planes), near(planes), none(planes);
  addMeasurable(scene, truth, 0.5, 10, all);
  addMeasurable(scene, truth, 0.5, 3, near);
  addMeasurable(scene, truth, 100, 101, none);
  EXPECT_GT(near.all, 0U);
  EXPECT_GT(all.all, near.all);
  EXPECT_EQ(none.all, 0U);
  std::size_t sum = 0;
  for (const std::size_t points : all.of_label)
    sum += points;
  EXPECT_EQ(sum, all.all);
  addMeasurable(scene, truth, 0.5, 10, none);
  EXPECT_EQ(none.of_label, all.of_label);
}

TEST(TruthFile, HasTheTruePlanesWithTheirPoints)
{
  const TemporaryFolder folder;
  const SimulatedScene scene = standardScene("room");
  TruthPoints points(scene.geometry.planes().size());
  points.all = 7;
  points.of_label[1] = 7;
  FramesOfTruth frames;
  frames.observations = 3;
  frames.lines = 200;
  frames.are_raw = true;
  saveFrameTruth(folder.path("truth.json"), scene, frames, points);
  const Json json = Json::parse(contentOf(folder.path("truth.json")));
  EXPECT_EQ(json["observations"], 3);
  EXPECT_EQ(json["frames"], "raw");
  EXPECT_EQ(json["lines"], 200);
  EXPECT_EQ(json["points"], 7);
  EXPECT_EQ(json["planes"].size(), scene.geometry.planes().size());
  EXPECT_EQ(json["planes"][0]["points"], 7);
  EXPECT_EQ(json["planes"][0]["rectangles"][0].size(), 4U);
  EXPECT_THROW(saveFrameTruth(folder.path("a.json"), scene, frames, TruthPoints(1)),
               BadArgumentException);
  EXPECT_THROW(saveFrameTruth(folder.path("no/a.json"), scene, frames, points),
               OutputFileException);
}

TEST(TruthFile, OfCloudsTellsTheSensor)
{
  const TemporaryFolder folder;
  SimulatedScene scene = standardScene("room");
  const SimulatedScene building = repeatedScene(scene, 2, 1);
  const TruthPoints points(building.geometry.planes().size());
  saveCloudTruth(folder.path("truth.json"), scene, building, 5, 2, points);
  Json json = Json::parse(contentOf(folder.path("truth.json")));
  EXPECT_EQ(json["seed"], 5);
  EXPECT_EQ(json["noise"]["along"], "ray");
  EXPECT_EQ(json["planes"].size(), building.geometry.planes().size());
  scene.depth_camera.emplace();
  saveCloudTruth(folder.path("truth.json"), scene, building, 5, 2, points);
  json = Json::parse(contentOf(folder.path("truth.json")));
  EXPECT_EQ(json["sensor"], "kinect");
  EXPECT_EQ(json["noise"]["along"], "disparity");
}

TEST(MergedRows, AreThePointsOfMergedObservations)
{
  SimulatedScene scene = standardScene("room");
  scene.views.resize(2);
  const MergedObservations expected = mergeObservations(scene, 2, 1);
  MergedRows rows(expected.trajectory);
  for (std::size_t view = 0; view < 2; ++view)
    rows.append(observe(scene, view, 1), view);
  EXPECT_THROW(rows.append(observe(scene, 0, 1), 2), BadArgumentException);
  const PCLPointCloud2 cloud = rows.finish().copy();
  EXPECT_GT(cloud.width, 0U);
  EXPECT_EQ(cloud.data, cloudOf(expected).data);
}

} // namespace
} // namespace pcl::acmap::test
