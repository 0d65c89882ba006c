#include "outline_tables.h"

#include "map_outlines.h"
#include "markdown_row.h"
#include "simulated_clouds.h"
#include "units.h"

#include <pcl/simulation/standard_scenes.h>

#include <iostream>

namespace pcl::acmap::bench {
namespace {

constexpr std::size_t points_a_view = 20000;

/** \brief Copies of a scene side by side, each with its own sensors, at heights and in
 * directions of their own: otherwise, their planes would be one. */
JudgedCloud
observeCopies(const MergedObservations& one, std::size_t copies)
{
  constexpr std::size_t a_row = 7;
  constexpr double step = 40, rise = 0.5, turn = 0.25; // metres, radians
  MergedObservations all;
  for (std::size_t copy = 0; copy < copies; ++copy) {
    const auto number = static_cast<double>(copy);
    const Eigen::Isometry3d T_all_one =
        Eigen::Translation3d(step * static_cast<double>(copy % a_row),
                             rise * number,
                             step * static_cast<double>(copy / a_row)) *
        Eigen::AngleAxisd(turn * number, Eigen::Vector3d::UnitY());
    const auto first_view = static_cast<std::int32_t>(all.trajectory.poses.size());
    for (const Eigen::Isometry3d& pose : one.trajectory.poses)
      all.trajectory.poses.push_back(T_all_one * pose);
    for (const Eigen::Vector3f& point : one.points)
      all.points.emplace_back(T_all_one.cast<float>() * point);
    for (const std::int32_t view : one.view)
      all.view.push_back(first_view + view);
  }
  all.rgb.resize(all.points.size());
  all.label.resize(all.points.size());
  const auto file = std::make_shared<PointCloudFile>();
  file->cloud = cloudOf(all);
  std::vector<Eigen::Vector3f> viewpoints;
  for (const Eigen::Isometry3d& pose : all.trajectory.poses)
    viewpoints.emplace_back(pose.translation().cast<float>());
  return {file, viewpoints};
}

} // namespace

void
printOutlineSizes()
{
  SimulatedScene scene = standardScene("loop");
  scene.sensor.points = points_a_view;
  const MergedObservations one = makeSceneCloud(scene).merged;
  std::cout << "\n### Outlines of many planes\n\n";
  printHead({"copies of `loop`",
             "points",
             "planes",
             "vertices a plane",
             "outlines, CPU s",
             "a plane, ms"});
  for (const std::size_t copies : {1, 8, 46}) {
    const JudgedMap map = findJudgedMap(observeCopies(one, copies));
    const auto planes = static_cast<double>(map.planes.size());
    MarkdownRow()
        .count(copies)
        .count(copies * one.points.size())
        .count(map.planes.size())
        .number(
            countOutlines(makeOutlines(map.planes, scene.views.front())).vertices_mean,
            1)
        .number(map.seconds, 3)
        .number(milli * map.seconds / planes, 2)
        .print();
  }
}

} // namespace pcl::acmap::bench
