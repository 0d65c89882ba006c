#include "temporary_folder.h"

#include <pcl/simulation/scene_file.h>
#include <pcl/simulation/standard_scenes.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

/** The lines of a valid scene; tests replace one of them. */
std::vector<std::string>
soundLines()
{
  return {
      "name: cell",
      "rig: {width: 320, height: 240, focal_length: 260, center_x: 159.5, center_y: "
      "119.5, baseline_horizontal: 0.1, baseline_vertical: 0, disparity_sigma: 0.2}",
      "sensor: {reach: 4.5, total_points: 1001}",
      "looks:",
      "  plain: {color: [10, 20, 30], texture: 0}",
      "surfaces:",
      "  - rectangle: {name: floor, corner: [0, 1, 0], edges: [[3, 0, 0], [0, 0, "
      "3]], look: plain}",
      "  - box: {name: crate, least: [1, 0, 1], most: [2, 1, 2], look: plain, "
      "faces: [top, left]}",
      "  - cylinder: {name: post, base: [0, 1, 3], axis: [0, -2, 0], radius: 0.1, "
      "look: plain, caps: true}",
      "path:",
      "  - pose: {at: [0, 0, 0], yaw: 90}",
      "  - line: {from: [0, 0, 0], to: [3, 0, 0], views: 4, yaw: [0, -90]}",
      "  - turn: {at: [3, 0, 0], from: 0, to: 180, views: 3}"};
}

SimulatedScene
load(const std::vector<std::string>& lines)
{
  const TemporaryFolder folder;
  std::string text;
  for (const std::string& line : lines)
    text += line + "\n";
  return loadSimulatedScene(folder.write("scene.yaml", text));
}

TEST(SceneFile, GivesWhatItSays)
{
  const SimulatedScene scene = load(soundLines());
  EXPECT_EQ(scene.name, "cell");
  EXPECT_EQ(scene.rig.width, 320);
  EXPECT_EQ(scene.rig.disparity_sigma, 0.2);
  EXPECT_EQ(scene.sensor.reach, 4.5);
  ASSERT_EQ(scene.views.size(), 8u);
  EXPECT_EQ(scene.sensor.points, 125u);
  EXPECT_EQ(scene.sensor.views_with_one_more, 1u);
  ASSERT_EQ(scene.geometry.surfaces().size(), 1u + 2u + 3u);
  ASSERT_EQ(scene.geometry.planes().size(), 3u);
  EXPECT_EQ(scene.geometry.planes()[0].name, "floor");
  EXPECT_EQ(scene.geometry.surfaces()[3].plane, -1);
  EXPECT_EQ(scene.geometry.surfaces()[0].look.color[2], 30);
}

TEST(SceneFile, PathTurnsZTowardsX)
{
  const SimulatedScene scene = load(soundLines());
  const auto looks = [&](std::size_t view) -> Eigen::Vector3d {
    return scene.views[view].linear().col(2);
  };
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), z = Eigen::Vector3d::UnitZ();
  EXPECT_TRUE(looks(0).isApprox(x, 1e-12)); // pose
  EXPECT_TRUE(looks(1).isApprox(x, 1e-12)); // along the line
  EXPECT_TRUE(looks(2).isApprox(z, 1e-12)); // 90 degrees to the left of the line
  EXPECT_TRUE(looks(5).isApprox(z, 1e-12)); // turn
  EXPECT_TRUE(looks(6).isApprox(x, 1e-12));
  EXPECT_TRUE(looks(7).isApprox(-z, 1e-12));
  EXPECT_TRUE(scene.views[2].translation().isApprox(x, 1e-12));
  EXPECT_TRUE(scene.views[4].translation().isApprox(3 * x, 1e-12));
  for (const Eigen::Isometry3d& view : scene.views)
    EXPECT_TRUE(view.linear().col(1).isApprox(Eigen::Vector3d::UnitY(), 1e-12));
}

TEST(SceneFile, WhatIsNotSaidIsStandard)
{
  std::vector<std::string> lines = soundLines();
  lines.erase(lines.begin() + 1, lines.begin() + 3);
  const SimulatedScene scene = load(lines);
  EXPECT_EQ(scene.rig.width, 640);
  EXPECT_EQ(scene.sensor.points, 138653u);
  EXPECT_EQ(scene.sensor.reach, 6.0);
}

std::vector<std::string>
linesOfBuilding(const std::string& building)
{
  std::vector<std::string> lines = soundLines();
  lines.erase(lines.begin() + 3, lines.begin() + 9);
  lines.push_back("building: " + building);
  return lines;
}

TEST(SceneFile, MayHaveTheBuildingOfAStandardScene)
{
  const SimulatedScene scene = load(linesOfBuilding("office"));
  EXPECT_EQ(scene.name, "cell");
  EXPECT_EQ(scene.views.size(), 8u);
  EXPECT_EQ(scene.geometry.surfaces().size(),
            standardScene("office").geometry.surfaces().size());
}

TEST(SceneFile, AnotherBuildingIsRefused)
{
  EXPECT_THAT([&] { load(linesOfBuilding("castle")); },
              testing::ThrowsMessage<InputFileException>(
                  testing::AllOf(HasSubstr("line 8, column 11: building: "),
                                 HasSubstr("'castle' is no standard scene"))));
}

/** A line number of the valid scene, its replacement, and a part of the error
 * message. */
struct BadScene {
  const char* name;
  std::size_t line; // starting at 1; 0 for a missing file
  std::string text;
  const char* fault;
};

void
PrintTo(const BadScene& bad, std::ostream* stream)
{
  *stream << bad.name;
}

class BadSceneTest : public testing::TestWithParam<BadScene> {};

TEST_P(BadSceneTest, IsRefusedWithFileLineAndFault)
{
  std::vector<std::string> lines = soundLines();
  lines[GetParam().line - 1] = GetParam().text;
  EXPECT_THAT([&] { load(lines); },
              testing::ThrowsMessage<InputFileException>(testing::AllOf(
                  HasSubstr("scene.yaml: "), HasSubstr(GetParam().fault))));
}

std::string
rectangle(const std::string& edges, const std::string& more = "look: plain")
{
  return "  - rectangle: {name: floor, corner: [0, 1, 0], edges: " + edges + ", " +
         more + "}";
}

INSTANTIATE_TEST_SUITE_P(
    Keys,
    BadSceneTest,
    testing::Values(
        BadScene{"noName", 1, "", "key 'name' is missing"},
        BadScene{"unknownKey", 1, "nome: cell", "line 1, column 1: key 'nome' is not"},
        BadScene{"twoBuildings", 1, "name: cell\nbuilding: loop", "line 6"},
        BadScene{"twice", 5, "  plain: {color: [1, 2, 3], color: 1}", "line 5"},
        BadScene{"noYaml", 7, "  - rectangle: {name: floor", "no YAML"},
        BadScene{"rig", 2, "rig: {width: -3, height: 9}", "line 2, column 14: width"},
        BadScene{"reach", 3, "sensor: {reach: .nan}", "line 3, column 17: reach"},
        BadScene{"noPoints", 3, "sensor: {points: 0}", "line 3, column 18: points"},
        BadScene{"both", 3, "sensor: {points: 9, total_points: 99}", "line 3"},
        BadScene{"huge", 3, "sensor: {points: 99999999999999999999}", "line 3"},
        BadScene{"color", 5, "  plain: {color: [1, 2, 256], texture: 0}", "line 5"},
        BadScene{"colors", 5, "  plain: {color: [1, 2], texture: 0}", "a list of 3"},
        BadScene{"texture", 5, "  plain: {color: [1, 2, 3], texture: -1}", "texture"}));

INSTANTIATE_TEST_SUITE_P(
    Surfaces,
    BadSceneTest,
    testing::Values(
        BadScene{"zeroSize", 7, rectangle("[[0, 0, 0], [0, 0, 3]]"), "line 7"},
        BadScene{"skew", 7, rectangle("[[1, 0, 0], [1, 0, 3]]"), "angle"},
        BadScene{"infinite", 7, rectangle("[[.inf, 0, 0], [0, 0, 3]]"), "line 7"},
        BadScene{"farAway", 7, rectangle("[[1e9, 0, 0], [0, 0, 3]]"), "line 7"},
        BadScene{"oneEdge", 7, rectangle("[[1, 0, 0]]"), "a list of 2 values"},
        BadScene{"noLook",
                 7,
                 rectangle("[[1, 0, 0], [0, 0, 3]]", "look: glass"),
                 "'glass' is none of the looks"},
        BadScene{"unknownShape", 7, "  - sphere: {name: s}", "'sphere' is no surface"},
        BadScene{"empty", 7, "  - {}", "line 7"},
        BadScene{"noMap", 7, "  - floor", "line 7"},
        BadScene{
            "openings",
            7,
            rectangle("[[3, 0, 0], [0, 0, 3]]",
                      "look: plain, openings: {name: d, at: [9], width: 1, height: "
                      "2, depth: 0.1, panel: plain, reveal: plain, floor: floor}"),
            "line 7"},
        BadScene{"otherPlane",
                 8,
                 "  - rectangle: {name: a, plane: floor, corner: [0, 2, 0], edges: "
                 "[[1, 0, 0], [0, 0, 1]], look: plain}",
                 "line 8, column 5: distance of a rectangle's corner from its plane"},
        BadScene{"face",
                 8,
                 "  - box: {name: c, least: [1, 0, 1], most: [2, 1, 2], look: plain, "
                 "faces: [lid]}",
                 "'lid' is no face"},
        BadScene{"flatBox",
                 8,
                 "  - box: {name: c, least: [1, 0, 1], most: [2, 0, 2], look: plain}",
                 "line 8"},
        BadScene{
            "thinPost",
            9,
            "  - cylinder: {name: p, base: [0, 1, 3], axis: [0, -2, 0], radius: 0, "
            "look: plain}",
            "line 9"},
        BadScene{
            "caps",
            9,
            "  - cylinder: {name: p, base: [0, 1, 3], axis: [0, -2, 0], radius: 1, "
            "look: plain, caps: maybe}",
            "true or false"}));

INSTANTIATE_TEST_SUITE_P(
    Paths,
    BadSceneTest,
    testing::Values(
        BadScene{
            "word", 11, "  - jump: {at: [0, 0, 0]}", "'jump' is no part of a path"},
        BadScene{"noYaw", 11, "  - pose: {at: [0, 0, 0]}", "key 'yaw' is missing"},
        BadScene{"spin", 11, "  - pose: {at: [0, 0, 0], yaw: 1e6}", "line 11"},
        BadScene{"noWay",
                 12,
                 "  - line: {from: [0, 0, 0], to: [0, 1, 0], views: 4}",
                 "line 12, column 11: line: the line has no direction"},
        BadScene{"noViews",
                 12,
                 "  - line: {from: [0, 0, 0], to: [1, 0, 0], views: 0}",
                 "views: '0'"},
        BadScene{"manyViews",
                 12,
                 "  - line: {from: [0, 0, 0], to: [1, 0, 0], views: 1000000000000}",
                 "line 12"},
        BadScene{"tooMany",
                 13,
                 "  - turn: {at: [3, 0, 0], from: 0, to: 180, views: 100000}",
                 "line 13, column 5: the path has more than 100000 views"},
        BadScene{"noYaws",
                 12,
                 "  - line: {from: [0, 0, 0], to: [1, 0, 0], views: 4, yaw: []}",
                 "a list of 1 to"}));

} // namespace
} // namespace pcl::acmap::test
