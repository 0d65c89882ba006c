#include "bench.h"
#include "bench_data.h"

#include <pcl/core/noise_scale.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/random.h>
#include <pcl/core/trajectory.h>
#include <pcl/filters/consolidation_types.h>
#include <pcl/pipeline/plane_mapping.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <pcl/conversions.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

namespace pcl::acmap::bench {
namespace {

PointXYZ
pointAt(const Eigen::Vector3f& place)
{
  return {place.x(), place.y(), place.z()};
}

/** Scans by others: a room, corridors, an office, a flat, a room by phone and one by a robot's
 * laser. They were looked at while the limits of planes were chosen. */
const std::vector<const char*> buildings = {"D_large/grenoble_room_5.2M.ply.xz",
                                            "D_large/wtc37_corridor_1M.ply.xz",
                                            "F_planes/navvis_room1/room1_gt_fine.pcd",
                                            "H_field/clouds/flat_15000.ply",
                                            "H_field/clouds/room_y_up.ply",
                                            "C_sequence/pcl_room_scans/room_scan1.pcd"};

/** A random part of the points of a cloud, as a cloud in space. */
std::shared_ptr<PointCloudFile>
partOf(const PointCloudFile& file, double share)
{
  std::vector<std::size_t> order(file.points().size());
  std::iota(order.begin(), order.end(), 0);
  Random random(61);
  const auto count =
      static_cast<std::size_t>(share * static_cast<double>(order.size()));
  for (std::size_t i = 0; i < count; ++i)
    std::swap(order[i], order[i + random.bits() % (order.size() - i)]);
  std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count));
  auto part = std::make_shared<PointCloudFile>(file);
  const std::size_t step = file.cloud.point_step;
  for (std::size_t i = 0; i < count; ++i)
    std::copy_n(file.cloud.data.begin() + static_cast<std::ptrdiff_t>(order[i] * step),
                step,
                part->cloud.data.begin() + static_cast<std::ptrdiff_t>(i * step));
  part->cloud.data.resize(count * step);
  part->cloud.width = static_cast<std::uint32_t>(count);
  part->cloud.height = 1;
  part->cloud.row_step = static_cast<std::uint32_t>(count * step);
  return part;
}

/** The voxel that the noise of the whole cloud and the spacing of the part allow, metres. */
double
allowedVoxel(const NoiseScale& whole, const NoiseScale& part)
{
  NoiseScale known = part;
  known.sigma = whole.sigma;
  return automaticVoxel(known);
}

/** \param[in,out] whole set by the first part */
void
printPart(const PointCloudFile& file,
          const std::string& name,
          double share,
          NoiseScale& whole)
{
  PlaneMapping mapping;
  mapping.setInputCloud(partOf(file, share));
  MappedPlanes result;
  mapping.compute(result);
  const PlaneMappingReport& report = mapping.getReport();
  const NoiseScale scale = report.noise_scale.value_or(NoiseScale());
  if (share == 1)
    whole = scale;
  const double allowed = allowedVoxel(whole, scale);
  const double used = report.consolidation ? report.consolidation->voxel_size : 0;
  constexpr double storey = 0.1; // metres of rmse
  double roughest = 0;
  std::size_t storeys = 0;
  for (const PlanePatch& plane : result.planes) {
    roughest = std::max(roughest, plane.rms);
    storeys += plane.rms > storey;
  }
  Row row;
  row << name << figure(centi * share, 0) << result.finite_points
      << figure(milli * scale.spacing, 0) << (scale.is_determined ? "" : "undetermined")
      << figure(milli * scale.sigma, 1) << figure(milli * used, 0);
  if (used > 0)
    row << atMost(std::max(used / allowed, allowed / used), 2, 2);
  else
    row << no_value;
  row << result.planes.size() << figure(milli * roughest, 1) << atMost(storeys, 0, 0)
      << report.remarks.size();
}

constexpr double shares[] = {1.0, 0.3, 0.1, 0.03, 0.01};

void
printHeadOfParts()
{
  printHead("building | part, % | points | spacing, mm | | sigma, mm | voxel, mm | "
            "times the allowed one | planes | roughest plane, mm | storeys as planes | "
            "remarks");
}

void
printParts()
{
  printHeadOfParts();
  for (const char* building : buildings)
    if (const std::optional<std::string> path = pathOfData(building)) {
      const PointCloudFile file = loadMaybePacked(*path);
      NoiseScale whole;
      for (const double share : shares)
        printPart(file, building, share, whole);
    }
}

/** A building and its yard, carried laser with odometry: not looked at before. */
void
printHeldOut()
{
  const std::string folder = "C_sequence/livox_scans_60";
  const std::optional<std::string> path = pathOfData(folder + "/trajectory.txt");
  if (!path)
    return;
  constexpr float unit = 1.0F / 500; // metres
  const auto cloud = std::make_shared<PointCloud<PointXYZ>>();
  const Trajectory trajectory = loadTrajectory(*path);
  for (std::size_t i = 0; i < trajectory.poses.size(); ++i) {
    const std::string number = std::to_string(i);
    const PointCloudFile file = loadMaybePacked(
        pathOfData(folder + "/scan_" + std::string(3 - number.size(), '0') + number +
                   ".ply.xz")
            .value());
    const Eigen::Isometry3f pose = trajectory.poses[i].cast<float>();
    const PointView points = file.points();
    for (std::size_t k = 0; k < points.size(); ++k)
      cloud->push_back(pointAt(pose * (unit * points[k])));
  }
  PointCloudFile merged;
  toPCLPointCloud2(*cloud, merged.cloud);
  merged.sensor_statement = SensorStatement::NoSensor;
  printHeadOfParts();
  NoiseScale whole;
  for (const double share : shares)
    printPart(merged, folder, share, whole);
}

const Section parts_section("parts", printParts);
const Section held_out_section("held_out", printHeldOut);

} // namespace
} // namespace pcl::acmap::bench
