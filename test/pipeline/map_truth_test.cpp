#include "truth_room.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

constexpr double fine = 1e-5; // tolerance for polygons, which are floats

class MapTruth : public testing::Test {
protected:
  MapFigures
  figures() const
  {
    return compareWithTruth(map_, way_, session_.load());
  }

  RoomSession session_;
  CompactMap map_ = roomMap();
  MappedTrajectory way_ = trueWay();
};

PlaneDeviation
planeOf(const MapDeviation& deviation, const std::string& name)
{
  for (const PlaneDeviation& plane : deviation.planes)
    if (plane.name == name)
      return plane;
  ADD_FAILURE() << name << " is no main plane";
  return {};
}

TEST_F(MapTruth, OfTheRoomAsItIsIsZero)
{
  const MapFigures result = figures();
  for (const MapDeviation& deviation : {result.aligned, result.from_first}) {
    EXPECT_EQ(deviation.found, 4u);
    EXPECT_NEAR(deviation.largest_angle, 0, fine);
    EXPECT_NEAR(deviation.largest_offset, 0, fine);
    EXPECT_NEAR(deviation.ate_before, 0, 1e-9);
    EXPECT_NEAR(deviation.ate_after, 0, 1e-9);
  }
  EXPECT_NEAR(planeOf(result.aligned, "floor").overlap, 80, 1e-3);
  EXPECT_NEAR(planeOf(result.aligned, "left wall").overlap, 50, 1e-3);
}

TEST_F(MapTruth, PlanesWithAHundredthOfThePointsAreMain)
{
  // of 9180 points, the far end has 1.09 %, the board 0.87 %
  std::vector<std::string> names;
  for (const PlaneDeviation& plane : figures().aligned.planes)
    names.push_back(plane.name);
  EXPECT_THAT(names,
              testing::ElementsAre("floor", "left wall", "right wall", "far end"));
}

TEST_F(MapTruth, TellsAngleAndOffsetOfAPlane)
{
  Eigen::Isometry3d motion = turnAt({-2, 0, 10}, 0.5);
  motion.pretranslate(Eigen::Vector3d(0.02, 0, 0));
  map_.planes[1] = moved(map_.planes[1], motion);
  const MapDeviation deviation = figures().aligned;
  EXPECT_EQ(deviation.found, 4u);
  const PlaneDeviation wall = planeOf(deviation, "left wall");
  EXPECT_EQ(wall.finder, 1u);
  EXPECT_NEAR(wall.angle, 0.5, fine);
  EXPECT_NEAR(wall.offset, 0.02, 1e-4);
  EXPECT_NEAR(deviation.largest_angle, 0.5, fine);
  EXPECT_NEAR(deviation.mean_angle, 0.5 / 4, fine);
  EXPECT_NEAR(deviation.largest_offset, 0.02, 1e-4);
  EXPECT_NEAR(deviation.mean_offset, 0.02 / 4, 1e-4);
}

TEST_F(MapTruth, OffsetIsThatInTheMiddleOfWhatWasFound)
{
  // only the last 10 m, rotated about the start of the wall: the centre of the part is
  // 15 m from there
  const PlanePatch part = patchOf({-2, 1.25, 10}, {0, 0, 10}, {0, -2.5, 0});
  map_.planes[1] = moved(part, turnAt({-2, 0, 0}, 0.2));
  const PlaneDeviation wall = planeOf(figures().aligned, "left wall");
  EXPECT_NEAR(wall.offset, 15 * std::sin(0.2 * M_PI / 180), 1e-3);
  EXPECT_NEAR(wall.overlap, 25, 0.1);
}

TEST_F(MapTruth, NormalsMayLookToTheOtherSide)
{
  map_.planes[1] = patchOf({-2, 1.25, 0}, {0, -2.5, 0}, {0, 0, 20});
  EXPECT_EQ(figures().aligned.found, 4u);
}

TEST_F(MapTruth, WhatIsTooFarOffIsNotFound)
{
  const PlanePatch wall = map_.planes[1];
  const auto is_found = [&](const PlanePatch& patch) {
    map_.planes[1] = patch;
    const MapDeviation deviation = figures().aligned;
    EXPECT_EQ(deviation.planes.size(), 4u);
    return planeOf(deviation, "left wall").finder.has_value();
  };
  const auto shifted = [&](double x) {
    return moved(wall, Eigen::Isometry3d(Eigen::Translation3d(x, 0, 0)));
  };
  EXPECT_TRUE(is_found(moved(wall, turnAt({-2, 0, 10}, 2.9))));
  EXPECT_FALSE(is_found(moved(wall, turnAt({-2, 0, 10}, 3.1))));
  EXPECT_TRUE(is_found(shifted(-0.099)));
  EXPECT_FALSE(is_found(shifted(-0.101)));
  EXPECT_TRUE(is_found(patchOf({-2, 1.25, 11}, {0, 0, 17}, {0, -2.5, 0})));
  EXPECT_FALSE(is_found(patchOf({-2, 1.25, 11}, {0, 0, 19}, {0, -2.5, 0})));
  EXPECT_FALSE(is_found(PlanePatch()));
}

TEST_F(MapTruth, HolesAreNotFound)
{
  const auto window = patchOf({-2, 1, 5}, {0, -2, 0}, {0, 0, 5}).polygons[0].outer;
  map_.planes[1].polygons[0].holes = {window};
  EXPECT_NEAR(planeOf(figures().aligned, "left wall").overlap, 40, 1e-3);
}

TEST_F(MapTruth, TheLargestOfSeveralCounts)
{
  const Eigen::Isometry3d motion(Eigen::Translation3d(0.01, 0, 0));
  map_.planes.push_back(moved(patchOf({-2, 1.25, 0}, {0, 0, 8}, {0, -2.5, 0}), motion));
  EXPECT_EQ(planeOf(figures().aligned, "left wall").finder, 1u);
  std::swap(map_.planes[1], map_.planes[4]);
  EXPECT_EQ(planeOf(figures().aligned, "left wall").finder, 4u);
}

/** 50 square metres, of which 8 and 6 m of the length are covered, 2 m of it twice. */
TEST_F(MapTruth, PiecesCoverAWallTogether)
{
  EXPECT_NEAR(planeOf(figures().aligned, "left wall").cover, 50, 0.2);
  map_.planes[1] = patchOf({-2, 1.25, 0}, {0, 0, 8}, {0, -2.5, 0});
  EXPECT_NEAR(planeOf(figures().aligned, "left wall").cover, 20, 0.2);
  map_.planes.push_back(patchOf({-2, 1.25, 6}, {0, 0, 6}, {0, -2.5, 0}));
  const PlaneDeviation wall = planeOf(figures().aligned, "left wall");
  EXPECT_NEAR(wall.overlap, 20, 1e-3) << "of the largest";
  EXPECT_NEAR(wall.cover, 30, 0.2);
  map_.planes[1].polygons[0].holes = {
      patchOf({-2, 1, 1}, {0, -2, 0}, {0, 0, 5}).polygons[0].outer};
  EXPECT_NEAR(planeOf(figures().aligned, "left wall").cover, 20, 0.2);
  map_.planes.resize(1);
  EXPECT_EQ(planeOf(figures().aligned, "left wall").cover, 0);
}

/** Between points on a line are triangles without an area, but for rounding, which also
 * turns them out of the plane. */
TEST_F(MapTruth, SliversDoNotTellTheScale)
{
  auto& outer = map_.planes[1].polygons[0].outer;
  const Eigen::Vector3f from = outer[0];
  outer[1].y() -= 0.7F;
  const Eigen::Vector3f edge = outer[1] - from;
  for (int k = 10; k > 0; --k)
    outer.insert(outer.begin() + 1, from + static_cast<float>(k) / 97 * edge);
  constexpr double cover = 50 - 0.7 * 20 / 2;
  for (int angle = 0; angle < 180; angle += 15) {
    const Eigen::Isometry3d motion = turnAt({0, 0, 0}, angle);
    CompactMap turned = map_;
    for (PlanePatch& plane : turned.planes)
      plane = moved(plane, motion);
    MappedTrajectory way = way_;
    for (auto* poses : {&way.before, &way.after})
      for (Eigen::Isometry3d& T_map_camera : *poses)
        T_map_camera = motion * T_map_camera;
    const MapFigures result = compareWithTruth(turned, way, session_.load());
    EXPECT_NEAR(planeOf(result.aligned, "left wall").cover, cover, 0.2) << angle;
  }
}

/** The board, 5 cm in front of the left wall, is within the tolerance for the wall. */
TEST_F(MapTruth, APlaneStandsForOneOnly)
{
  const RoomSession session(
      std::string(roomTruth())
          .replace(roomTruth().find("\"points\": 80"), 12, "\"points\": 900"));
  const auto deviation = [&] {
    return compareWithTruth(map_, way_, session.load()).aligned;
  };
  ASSERT_EQ(deviation().planes.size(), 5u);
  EXPECT_FALSE(planeOf(deviation(), "board").finder) << "the wall is no board";
  map_.planes.push_back(patchOf({-1.95, 0.45, 5.1}, {0, 0, 0.9}, {0, -0.95, 0}));
  EXPECT_EQ(planeOf(deviation(), "left wall").finder, 1u);
  EXPECT_EQ(planeOf(deviation(), "board").finder, 4u);
}

TEST_F(MapTruth, AFirstPoseThatIsWrongTurnsAllOfIt)
{
  const Eigen::Isometry3d T_map_truth = turnAt(Eigen::Vector3d::Zero(), 0.2);
  for (PlanePatch& plane : map_.planes)
    plane = moved(plane, T_map_truth);
  for (std::size_t i = 1; i < way_.after.size(); ++i)
    way_.after[i] = T_map_truth * way_.after[i];
  const MapFigures result = figures();
  EXPECT_NEAR(result.aligned.largest_angle, 0, fine);
  EXPECT_NEAR(result.aligned.largest_offset, 0, fine);
  EXPECT_NEAR(result.aligned.ate_after, 0, 1e-9);
  EXPECT_NEAR(planeOf(result.from_first, "left wall").angle, 0.2, fine);
  EXPECT_NEAR(planeOf(result.from_first, "floor").angle, 0, fine);
  // the positions 2, 4, 6, 8 m ahead move sideways
  const double way = std::sqrt((4.0 + 16 + 36 + 64) / 5);
  EXPECT_NEAR(result.from_first.ate_after, 2 * std::sin(0.1 * M_PI / 180) * way, 1e-9);
}

TEST_F(MapTruth, TellsTheWayBeforeAndAfter)
{
  // alternating sides, so that neither rotation nor translation reduces the error
  const double sides[] = {1, -1, 0, -1, 1};
  for (std::size_t i = 0; i < way_.before.size(); ++i) {
    way_.before[i].translation().x() += 0.1 * sides[i];
    way_.after[i].translation().x() += 0.03 * sides[i];
  }
  const MapFigures result = figures();
  const double share = std::sqrt(4.0 / 5.0);
  EXPECT_NEAR(result.aligned.ate_before, 0.1 * share, 1e-9);
  EXPECT_NEAR(result.aligned.ate_after, 0.03 * share, 1e-9);
  // the first position has no error now, the others also have its error
  const double more = std::sqrt((0 + 4.0 + 1 + 4 + 0) / 5);
  EXPECT_NEAR(result.from_first.ate_before, 0.1 * more, 1e-9);
  EXPECT_NEAR(result.from_first.ate_after, 0.03 * more, 1e-9);
}

TEST_F(MapTruth, ObservationsMayBeLost)
{
  for (auto* const poses : {&way_.before, &way_.after})
    poses->erase(poses->begin());
  way_.observations = {1, 2, 3, 4};
  // the map's frame is now that of the second observation
  const Eigen::Isometry3d T_map_truth(Eigen::Translation3d(0, 0, -2));
  for (auto* const poses : {&way_.before, &way_.after})
    for (Eigen::Isometry3d& pose : *poses)
      pose = T_map_truth * pose;
  for (PlanePatch& plane : map_.planes)
    plane = moved(plane, T_map_truth);
  const MapFigures result = figures();
  EXPECT_EQ(result.from_first.found, 4u);
  EXPECT_NEAR(result.from_first.largest_offset, 0, fine);
  EXPECT_NEAR(result.from_first.ate_after, 0, 1e-9);
  way_.observations = {0, 2, 3, 4};
  EXPECT_GT(figures().aligned.ate_after, 0.1);
}

TEST_F(MapTruth, ACameraThatStoodStillHasNoWayToTurn)
{
  way_.observations = {0};
  way_.before.resize(1);
  way_.after.resize(1);
  const MapDeviation deviation = figures().aligned;
  EXPECT_EQ(deviation.found, 4u);
  EXPECT_NEAR(deviation.largest_angle, 0, fine);
  EXPECT_NEAR(deviation.ate_after, 0, 1e-9);
}

TEST_F(MapTruth, FitsItsObservations)
{
  way_.observations.back() = 5;
  EXPECT_THROW(
      {
        try {
          figures();
        }
        catch (const InputFileException& error) {
          EXPECT_THAT(error.what(), HasSubstr("trajectory.txt: has 5 poses"));
          EXPECT_THAT(error.what(), HasSubstr("observation 5"));
          throw;
        }
      },
      InputFileException);
  way_ = trueWay();
  way_.before.pop_back();
  EXPECT_THROW(figures(), BadArgumentException);
  way_ = {};
  EXPECT_THROW(figures(), BadArgumentException);
}

TEST_F(MapTruth, OfAMapWithoutPlanesHasNoFigures)
{
  map_ = {};
  const MapFigures result = figures();
  EXPECT_EQ(result.aligned.found, 0u);
  EXPECT_TRUE(std::isnan(result.aligned.mean_angle));
  const auto json = nlohmann::json::parse(truthDetailsText(result));
  EXPECT_EQ(json["main_planes_found"], 0);
  EXPECT_EQ(json["main_planes"], 4);
  EXPECT_TRUE(json["mean_angle_deg"].is_null());
  EXPECT_TRUE(json["largest_offset_m"].is_null());
  EXPECT_TRUE(json["planes"][0]["plane"].is_null());
  EXPECT_EQ(truthSummary(result)[0].second, "0 of 4 found");
}

/** The map has no pose of the third observation, the session no file of the first one. */
TEST_F(MapTruth, FollowsTheNamesAndTimesOfObservations)
{
  const Trajectory truth = roomWay();
  const TemporaryFolder folder;
  std::vector<std::string> files;
  const std::string pcd = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n"
                          "COUNT 1 1 1\nWIDTH 1\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n"
                          "POINTS 1\nDATA ascii\n1 2 3\n";
  Trajectory estimated;
  for (std::size_t i = 1; i < truth.poses.size(); ++i) {
    files.push_back(folder.write("observation_000" + std::to_string(i) + ".pcd", pcd));
    estimated.stamps.push_back(static_cast<double>(i));
    estimated.poses.push_back(truth.poses[i]);
  }
  const ObservationSequence observations =
      ObservationSequence(files).withPoses({0, 1, 2, 3}, estimated);
  map_.trajectory = estimated;
  map_.trajectory.stamps.erase(map_.trajectory.stamps.begin() + 1);
  map_.trajectory.poses.erase(map_.trajectory.poses.begin() + 1);
  const MapFigures result =
      compareWithTruth(map_, observations, estimated, session_.load());
  EXPECT_EQ(result.aligned.found, 4u);
  EXPECT_NEAR(result.from_first.ate_after, 0, 1e-9);
  EXPECT_NEAR(result.from_first.mean_offset, 0, fine);
}

TEST_F(MapTruth, IsAReport)
{
  map_.planes[1] = moved(map_.planes[1], turnAt({-2, 0, 10}, 0.4));
  MapFigures result = figures();
  result.compactness = 250;
  const auto json = nlohmann::json::parse(truthDetailsText(result));
  EXPECT_EQ(json["main_planes_found"], 4);
  EXPECT_EQ(json["main_planes"], 4);
  EXPECT_NEAR(json["mean_angle_deg"], 0.1, fine);
  EXPECT_NEAR(json["largest_angle_deg"], 0.4, fine);
  EXPECT_NEAR(json["mean_offset_m"], 0, 1e-4);
  EXPECT_NEAR(json["ate_before_m"], 0, 1e-9);
  EXPECT_NEAR(json["ate_after_m"], 0, 1e-9);
  EXPECT_EQ(json["compactness"], 250);
  EXPECT_EQ(json["planes"][1]["name"], "left wall");
  EXPECT_EQ(json["planes"][1]["plane"], 1);
  EXPECT_NEAR(json["planes"][1]["angle_deg"], 0.4, fine);
  EXPECT_NEAR(json["from_first"]["mean_angle_deg"], 0.1, fine);
  const auto lines = truthSummary(result);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].first, "true planes");
  EXPECT_THAT(lines[0].second, HasSubstr("4 of 4 found, 0.1 degrees and "));
  EXPECT_THAT(lines[0].second, HasSubstr("at most 0.4 degrees"));
  EXPECT_EQ(lines[1].first, "ATE");
}

} // namespace
} // namespace pcl::acmap::test
