#include "bench.h"
#include "bench_data.h"
#include "map_views.h"
#include "run_tool.h"
#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/trajectory.h>
#include <pcl/point_types.h>
#include <pcl/texture/compact_map_folder.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>

namespace pcl::acmap::bench {
namespace {

/** A photo that the map has not seen, and where it was taken. */
struct Photo {
  PointCloud<PointXYZRGB> cloud; ///< organized, camera frame
  Eigen::Isometry3d T_map_camera;
};

std::string
observationIn(const std::string& folder, std::size_t number)
{
  std::ostringstream path;
  path << folder << "/observation_" << std::setw(4) << std::setfill('0') << number
       << ".pcd";
  return path.str();
}

/** The frames between those of the map, posed by the given motion from the frame before. */
std::vector<Photo>
photosOf(const std::string& all, const Trajectory& of_map)
{
  const Trajectory given = loadTrajectory(all + "/trajectory.txt");
  std::vector<Photo> photos;
  for (std::size_t i = 1; i < given.poses.size(); i += 2) {
    Photo& photo = photos.emplace_back();
    fromPCLPointCloud2(loadPointCloud(observationIn(all, i)).cloud, photo.cloud);
    photo.T_map_camera =
        of_map.poses.at(i / 2) * given.poses[i - 1].inverse() * given.poses[i];
  }
  return photos;
}

/** How much a view of the map resembles a photo, over the pixels that have a depth. */
struct Resemblance {
  double similarity; ///< SSIM
  double psnr;       ///< dB
  double covered;    ///< share of those pixels of which the map has a colour
};

std::vector<std::uint8_t>
colorsOf(const PointCloud<PointXYZRGB>& cloud)
{
  std::vector<std::uint8_t> rgb;
  for (const PointXYZRGB& point : cloud)
    rgb.insert(rgb.end(), {point.r, point.g, point.b});
  return rgb;
}

/** Brings a view to the exposure of a photo by one gain, the least-squares one. */
void
expose(const std::vector<std::uint8_t>& photo, MapView& view)
{
  double products = 0, squares = 0;
  for (std::size_t i = 0; i < photo.size(); ++i)
    if (view.is_known[i / 3]) {
      products += static_cast<double>(photo[i]) * view.rgb[i];
      squares += static_cast<double>(view.rgb[i]) * view.rgb[i];
    }
  const double gain = squares > 0 ? products / squares : 1;
  for (std::uint8_t& value : view.rgb)
    value =
        static_cast<std::uint8_t>(std::lround(std::clamp(gain * value, 0.0, 255.0)));
}

Resemblance
compare(const Photo& photo, const CompactMap& map)
{
  const std::vector<std::uint8_t> rgb = colorsOf(photo.cloud);
  const std::optional<Pinhole> pinhole = fitUprightPinhole(
      {&photo.cloud.front().x, sizeof(PointXYZRGB), photo.cloud.size()},
      photo.cloud.width);
  MapView view = castMap(map,
                         {pinhole.value(),
                          static_cast<int>(photo.cloud.width),
                          static_cast<int>(photo.cloud.height)},
                         photo.T_map_camera);
  std::size_t measured = 0, covered = 0;
  for (std::size_t i = 0; i < photo.cloud.size(); ++i) {
    const bool has_depth = photo.cloud[i].getVector3fMap().allFinite();
    view.is_known[i] = has_depth && view.is_known[i] ? 1 : 0;
    measured += has_depth ? 1 : 0;
    covered += view.is_known[i];
  }
  expose(rgb, view);
  double squares = 0;
  for (std::size_t i = 0; i < rgb.size(); ++i)
    if (view.is_known[i / 3])
      squares += (rgb[i] - view.rgb[i]) * (rgb[i] - view.rgb[i]);
  const double mean = squares / (3.0 * static_cast<double>(covered));
  return {structuralSimilarity(rgb, view.rgb, view.is_known, photo.cloud.width),
          10 * std::log10(255.0 * 255.0 / mean),
          percent(covered, measured)};
}

void
printMap(const std::string& name,
         const std::vector<std::string>& options,
         const std::string& even,
         const std::string& all,
         const std::string& folder)
{
  std::vector<std::string> arguments = {even, "-o", folder, "--no-pictures"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Cost cost =
      measureCost([&] { test::runTool(ACMAP_COMPACT_MAPPING, arguments).succeeded(); });
  const CompactMap map = loadCompactMap(folder);
  std::vector<double> similarity, psnr, covered;
  for (const Photo& photo : photosOf(all, loadTrajectory(folder + "/trajectory.txt"))) {
    const Resemblance one = compare(photo, map);
    similarity.push_back(one.similarity);
    psnr.push_back(one.psnr);
    covered.push_back(one.covered);
  }
  std::size_t texels = 0;
  for (const TextureChart& chart : map.charts)
    texels += chart.kinds.size();
  const auto bytes = std::filesystem::file_size(folder + "/map.glb");
  Row() << name
        << figure(map.charts.empty() ? 0 : milli * map.charts.front().texel_u.norm(), 1)
        << texels << similarity.size() << figure(meanOf(similarity), 3)
        << figure(meanOf(psnr), 2) << figure(meanOf(covered), 1)
        << figure(1e-6 * static_cast<double>(bytes), 2) << figure(cost.wall, 1);
}

/** RedKitchen of 7-Scenes, mapped from every second frame, against the others. */
const Section kitchen_section("kitchen", [] {
  const auto recording = pathOfKitchen();
  if (!recording)
    return;
  const test::TemporaryFolder work;
  const std::string even = work.path("even"), all = work.path("all");
  test::runTool(ACMAP_RGBD_IMPORT, {*recording, "-o", even, "--every", "2"})
      .succeeded();
  test::runTool(ACMAP_RGBD_IMPORT, {*recording, "-o", all}).succeeded();
  printHead(
      "map of the even frames | texel, mm | texels | odd frames | SSIM | PSNR, dB "
      "| pixels with a depth that are covered, % | map.glb, MB | mapping, s");
  printMap("default", {}, even, all, work.path("map"));
  printMap("texels of 2 cm", {"--texel", "0.02"}, even, all, work.path("coarse"));
});

} // namespace
} // namespace pcl::acmap::bench
