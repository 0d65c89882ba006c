#include "bench.h"
#include "bench_data.h"
#include "run_tool.h"
#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/core/map_up.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>
#include <pcl/texture/compact_map_folder.h>

#include <fstream>

namespace pcl::acmap::bench {
namespace {

using Colored = PointCloud<PointXYZRGB>;

/** Mean differences of brightness, of 255, between places of walls. */
struct WallSteps {
  double next = 0;     ///< between neighbouring texels
  double apart = 0;    ///< between texels about 3 cm apart
  double smoothed = 0; ///< the same of the points within 10 cm, averaged
  std::size_t pairs = 0;
};

double
brightness(const std::uint8_t* color)
{
  return 0.299 * color[0] + 0.587 * color[1] + 0.114 * color[2];
}

/** Mean brightness of the points around a place. */
double
smoothedAt(const Eigen::Vector3d& place,
           const Colored& cloud,
           const KdTreeFLANN<PointXYZRGB>& tree)
{
  constexpr double radius = 0.1; // metres
  PointXYZRGB at;
  at.getVector3fMap() = place.cast<float>();
  Indices near;
  std::vector<float> squares;
  tree.radiusSearch(at, radius, near, squares);
  double sum = 0;
  for (const index_t i : near) {
    const std::uint8_t rgb[] = {cloud[static_cast<std::size_t>(i)].r,
                                cloud[static_cast<std::size_t>(i)].g,
                                cloud[static_cast<std::size_t>(i)].b};
    sum += brightness(rgb);
  }
  return near.empty() ? no_reach : sum / static_cast<double>(near.size());
}

void
addSteps(const TextureChart& chart,
         const Colored& cloud,
         const KdTreeFLANN<PointXYZRGB>& tree,
         WallSteps& steps)
{
  constexpr double distance = 0.03; // metres
  constexpr std::int32_t every = 7; // texels: a sample of all
  const auto far = std::max(
      1, static_cast<std::int32_t>(std::lround(distance / chart.texel_u.norm())));
  const auto isKnown = [&](std::int32_t column, std::int32_t row) {
    return column < chart.colors.width &&
           chart.kinds[static_cast<std::size_t>(row * chart.colors.width + column)] !=
               TexelKind::None;
  };
  const auto place = [&](std::int32_t column, std::int32_t row) -> Eigen::Vector3d {
    return chart.origin + (column + 0.5) * chart.texel_u + (row + 0.5) * chart.texel_v;
  };
  for (std::int32_t row = 0; row < chart.colors.height; row += every)
    for (std::int32_t column = 0; column < chart.colors.width; column += every) {
      if (!isKnown(column, row) || !isKnown(column + 1, row) ||
          !isKnown(column + far, row))
        continue;
      const double here = smoothedAt(place(column, row), cloud, tree);
      const double there = smoothedAt(place(column + far, row), cloud, tree);
      if (!std::isfinite(here + there))
        continue;
      const double level = brightness(chart.colors.at(column, row));
      steps.next += std::abs(level - brightness(chart.colors.at(column + 1, row)));
      steps.apart += std::abs(level - brightness(chart.colors.at(column + far, row)));
      steps.smoothed += std::abs(here - there);
      ++steps.pairs;
    }
}

/** The corridor of wtc37, scanned from several stations that no field names. */
const Section walls_section("walls", [] {
  const auto path = pathOfData("D_large/wtc37_corridor_1M.ply.xz");
  if (!path)
    return;
  const test::TemporaryFolder work;
  const std::string file = work.path("cloud.ply");
  std::ofstream(file, std::ios::binary) << contentOf(*path);
  const std::string folder = work.path("map");
  const Cost cost = measureCost([&] {
    test::runTool(ACMAP_COMPACT_MAPPING, {file, "-o", folder, "--no-pictures"})
        .succeeded();
  });
  const CompactMap map = loadCompactMap(folder);
  const Colored::Ptr cloud(new Colored);
  fromPCLPointCloud2(loadPointCloud(file).cloud, *cloud);
  for (PointXYZRGB& point : *cloud) // into the frame of the map
    point.getVector3fMap() -= map.shift.cast<float>();
  KdTreeFLANN<PointXYZRGB> tree;
  tree.setInputCloud(cloud);
  const Eigen::Vector3d up = upDirection(map);
  WallSteps steps;
  std::size_t texels = 0, seen = 0, filled = 0;
  for (const TextureChart& chart : map.charts) {
    for (const TexelKind kind : chart.kinds) {
      ++texels;
      seen += kind == TexelKind::Seen ? 1 : 0;
      filled += kind == TexelKind::Filled ? 1 : 0;
    }
    if (std::abs(map.planes[chart.plane].coefficients.head<3>().dot(up)) < 0.3)
      addSteps(chart, *cloud, tree, steps);
  }
  const auto count = static_cast<double>(steps.pairs);
  printHead(
      "cloud | texel, mm | texels | seen, % of the known | pairs on walls | step "
      "between neighbours | between texels 3 cm apart | of the points smoothed at "
      "10 cm | ratio | map.glb, MB | mapping, s");
  Row() << "wtc37_corridor_1M" << figure(milli * map.charts.at(0).texel_u.norm(), 1)
        << texels << figure(percent(seen, seen + filled), 1) << steps.pairs
        << figure(steps.next / count, 2) << figure(steps.apart / count, 2)
        << figure(steps.smoothed / count, 2) << figure(steps.apart / steps.smoothed, 2)
        << figure(1e-6 * static_cast<double>(
                             std::filesystem::file_size(folder + "/map.glb")),
                  2)
        << figure(cost.wall, 1);
});

} // namespace
} // namespace pcl::acmap::bench
