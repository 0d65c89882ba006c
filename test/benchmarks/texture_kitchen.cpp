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

#include <opencv2/imgproc.hpp>

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

ViewCamera
cameraOf(const Photo& photo)
{
  return {fitUprightPinhole(
              {&photo.cloud.front().x, sizeof(PointXYZRGB), photo.cloud.size()},
              photo.cloud.width)
              .value(),
          static_cast<int>(photo.cloud.width),
          static_cast<int>(photo.cloud.height)};
}

/** The map from the pose of a photo, in its exposure, where the photo has a depth. */
MapView
viewOf(const Photo& photo, const CompactMap& map)
{
  MapView view = castMap(map, cameraOf(photo), photo.T_map_camera);
  for (std::size_t i = 0; i < photo.cloud.size(); ++i)
    view.is_known[i] =
        view.is_known[i] && photo.cloud[i].getVector3fMap().allFinite() ? 1 : 0;
  expose(colorsOf(photo.cloud), view);
  return view;
}

Resemblance
compare(const Photo& photo, const CompactMap& map)
{
  const std::vector<std::uint8_t> rgb = colorsOf(photo.cloud);
  const MapView view = viewOf(photo, map);
  std::size_t measured = 0, covered = 0;
  for (std::size_t i = 0; i < photo.cloud.size(); ++i) {
    measured += photo.cloud[i].getVector3fMap().allFinite() ? 1 : 0;
    covered += view.is_known[i];
  }
  double squares = 0;
  for (std::size_t i = 0; i < rgb.size(); ++i)
    if (view.is_known[i / 3])
      squares += (rgb[i] - view.rgb[i]) * (rgb[i] - view.rgb[i]);
  const double mean = squares / (3.0 * static_cast<double>(covered));
  return {structuralSimilarity(rgb, view.rgb, view.is_known, photo.cloud.width),
          10 * std::log10(255.0 * 255.0 / mean),
          percent(covered, measured)};
}

/** Brightness, blurred. \param[in] radius of the box, pixels */
cv::Mat
blurred(const std::vector<std::uint8_t>& rgb, const ViewCamera& camera, int radius)
{
  const cv::Mat colors(
      camera.height, camera.width, CV_8UC3, const_cast<std::uint8_t*>(rgb.data()));
  cv::Mat grey;
  cv::cvtColor(colors, grey, cv::COLOR_RGB2GRAY);
  grey.convertTo(grey, CV_32F);
  cv::GaussianBlur(grey, grey, {4 * radius + 1, 4 * radius + 1}, radius);
  return grey;
}

/** Moves the camera of a photo by a step of Gauss-Newton towards where the map looks like it:
 * the error of the pose is not one of the texture. */
void
refine(const CompactMap& map, int radius, Photo& photo)
{
  constexpr double robust = 15; // levels
  const ViewCamera camera = cameraOf(photo);
  const MapView view = viewOf(photo, map);
  const cv::Mat wanted = blurred(colorsOf(photo.cloud), camera, radius);
  const cv::Mat shown = blurred(view.rgb, camera, radius);
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
  for (int row = 1; row + 1 < camera.height; ++row)
    for (int column = 1; column + 1 < camera.width; ++column) {
      const auto i = static_cast<std::size_t>(row * camera.width + column);
      const auto isKnown = [&](int c, int r) {
        return view
            .is_known[static_cast<std::size_t>((row + r) * camera.width + column + c)];
      };
      if (!isKnown(0, 0) || !isKnown(-1, 0) || !isKnown(1, 0) || !isKnown(0, -1) ||
          !isKnown(0, 1))
        continue;
      const double x =
          (wanted.at<float>(row, column + 1) - wanted.at<float>(row, column - 1)) / 2.0;
      const double y =
          (wanted.at<float>(row + 1, column) - wanted.at<float>(row - 1, column)) / 2.0;
      const double rest = static_cast<double>(shown.at<float>(row, column)) -
                          static_cast<double>(wanted.at<float>(row, column));
      const double depth = view.depth[i];
      const Eigen::Vector3d point(depth * (column - camera.pinhole.cx) /
                                      camera.pinhole.fx,
                                  depth * (row - camera.pinhole.cy) / camera.pinhole.fy,
                                  depth);
      const double of_x = x * camera.pinhole.fx / depth;
      const double of_y = y * camera.pinhole.fy / depth;
      const Eigen::Vector3d slope(
          of_x, of_y, -(of_x * point.x() + of_y * point.y()) / depth);
      Eigen::Matrix<double, 6, 1> row_of_motion;
      row_of_motion << point.cross(slope), slope;
      const double weight = std::min(1.0, robust / std::max(std::abs(rest), 1e-9));
      matrix += weight * row_of_motion * row_of_motion.transpose();
      right += weight * rest * row_of_motion;
    }
  matrix.diagonal().array() += 1;
  const Eigen::Matrix<double, 6, 1> motion = matrix.ldlt().solve(right);
  Eigen::Isometry3d T_new_old = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d turn = motion.head<3>();
  if (turn.norm() > 0)
    T_new_old.linear() =
        Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  T_new_old.translation() = motion.tail<3>();
  photo.T_map_camera = photo.T_map_camera * T_new_old.inverse();
}

Photo
refined(Photo photo, const CompactMap& map)
{
  for (const int radius : {6, 6, 6, 3, 3, 3, 1, 1, 1})
    refine(map, radius, photo);
  return photo;
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
  std::vector<double> similarity, psnr, covered, refined_similarity, refined_psnr;
  for (const Photo& photo : photosOf(all, loadTrajectory(folder + "/trajectory.txt"))) {
    const Resemblance one = compare(photo, map);
    similarity.push_back(one.similarity);
    psnr.push_back(one.psnr);
    covered.push_back(one.covered);
    const Resemblance other = compare(refined(photo, map), map);
    refined_similarity.push_back(other.similarity);
    refined_psnr.push_back(other.psnr);
  }
  std::size_t texels = 0;
  for (const TextureChart& chart : map.charts)
    texels += chart.kinds.size();
  const auto bytes = std::filesystem::file_size(folder + "/map.glb");
  Row() << name
        << figure(map.charts.empty() ? 0 : milli * map.charts.front().texel_u.norm(), 1)
        << texels << similarity.size() << figure(meanOf(similarity), 3)
        << figure(meanOf(psnr), 2) << figure(meanOf(refined_similarity), 3)
        << figure(meanOf(refined_psnr), 2) << figure(meanOf(covered), 1)
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
