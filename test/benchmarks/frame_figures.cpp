#include "bench.h"
#include "boxed_hall.h"
#include "laser_recording.h"

#include <pcl/core/impl/rigid_alignment.h>
#include <pcl/core/random.h>
#include <pcl/core/trajectory_error.h>
#include <pcl/filters/voxel_consolidation.h>
#include <pcl/mapping/entropy_rectification.h>
#include <pcl/mapping/map_levelling.h>
#include <pcl/mapping/plane_adjustment.h>
#include <pcl/pipeline/compact_mapping.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/standard_scenes.h>
#include <pcl/texture/floor_plan.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Do results depend on the frame in which a map is given? And how much is left of the drift of a few
// sparse clouds?

namespace pcl::acmap::bench {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Poses = std::vector<Isometry3d>;

/** Observations with their true poses, and those of an odometry. */
struct Recording {
  std::vector<std::shared_ptr<const PointCloudFile>> clouds;
  Poses truth, odometry;
};

/** Chains steps that err independently.
 * \param[in] length metres, \param[in] turn radians about y, \param[in] scale of the steps */
Poses
drifted(
    const Poses& truth, double length, double turn, double scale, std::uint64_t seed)
{
  Random random(seed);
  Poses result{truth.front()};
  for (std::size_t i = 1; i < truth.size(); ++i) {
    Isometry3d step = truth[i - 1].inverse() * truth[i];
    step.translation() *= scale;
    step.translation() += length * Vector3d(random.normal(), 0, random.normal());
    step.rotate(Eigen::AngleAxisd(turn * random.normal(), Vector3d::UnitY()));
    result.push_back(result.back() * step);
  }
  return result;
}

/** \param[in] coarse factor of the camera's pixels */
Recording
recordingOf(const std::string& name, std::size_t views, int coarse)
{
  SimulatedScene scene = standardScene(name);
  scene.rig.width /= coarse;
  scene.rig.height /= coarse;
  scene.rig.focal_length /= coarse;
  scene.rig.center_x = (scene.rig.width - 1) / 2.0;
  scene.rig.center_y = (scene.rig.height - 1) / 2.0;
  scene.sensor.points /=
      static_cast<std::size_t>(coarse) * static_cast<std::size_t>(coarse);
  Recording recording;
  for (std::size_t i = 0; i < std::min(views, scene.views.size()); ++i) {
    const auto file = std::make_shared<PointCloudFile>();
    file->cloud = cloudOf(observe(scene, i, 1));
    recording.clouds.push_back(file);
    recording.truth.push_back(scene.views[i]);
  }
  recording.odometry = drifted(recording.truth, 0.01, 0.01, 1, 3);
  return recording;
}

/** The same with its map turned. */
Recording
turned(const Matrix3d& turn, Recording recording)
{
  for (Poses* const poses : {&recording.truth, &recording.odometry})
    for (Isometry3d& pose : *poses)
      pose = Isometry3d(turn) * pose;
  return recording;
}

/** The same building in a mirror, in which left is right. */
Recording
mirrored(Recording recording)
{
  const Eigen::DiagonalMatrix<double, 4> mirror(-1, 1, 1, 1);
  for (Poses* const poses : {&recording.truth, &recording.odometry})
    for (Isometry3d& pose : *poses)
      pose = Isometry3d(Eigen::Matrix4d(mirror * pose.matrix() * mirror));
  for (std::shared_ptr<const PointCloudFile>& cloud : recording.clouds) {
    // the columns change sides, too, so that it is the image of a camera
    PointCloud<PointXYZRGBSigma> points, seen;
    fromPCLPointCloud2(cloud->cloud, points);
    seen = points;
    for (std::uint32_t row = 0; row < points.height; ++row)
      for (std::uint32_t column = 0; column < points.width; ++column) {
        PointXYZRGBSigma& point = seen(column, row);
        point = points(points.width - 1 - column, row);
        point.x = -point.x;
      }
    const auto file = std::make_shared<PointCloudFile>();
    toPCLPointCloud2(seen, file->cloud);
    cloud = file;
  }
  return recording;
}

template <typename PointT>
std::shared_ptr<PointCloud<PointT>>
pointsOf(const PointCloudFile& file)
{
  const auto cloud = std::make_shared<PointCloud<PointT>>();
  fromPCLPointCloud2(file.cloud, *cloud);
  return cloud;
}

/** A view with normals, as the pages of the classes advise. */
std::shared_ptr<PointCloud<PointNormal>>
withNormals(const PointCloudFile& file)
{
  VoxelConsolidation<PCLPointCloud2> consolidation;
  consolidation.setInputCloud(std::make_shared<PCLPointCloud2>(file.cloud));
  PCLPointCloud2 voxels;
  consolidation.filter(voxels);
  const auto cloud = std::make_shared<PointCloud<PointNormal>>();
  fromPCLPointCloud2(voxels, *cloud);
  return cloud;
}

double
errorOf(const Poses& poses, const Poses& truth)
{
  double largest = 0; // after both begin at the same pose
  for (std::size_t i = 0; i < poses.size(); ++i)
    largest = std::max(largest,
                       ((poses.front().inverse() * poses[i]).translation() -
                        (truth.front().inverse() * truth[i]).translation())
                           .norm());
  return largest;
}

/** Poses of a class that registers clouds. */
template <typename Registration>
Poses
posesOf(const Registration& registration, std::size_t size)
{
  Poses poses;
  for (std::size_t i = 0; i < size; ++i)
    poses.push_back(registration.getPose(i));
  return poses;
}

template <typename Clouds>
EntropyRectification<PointNormal>
rectified(const Clouds& clouds, const Poses& odometry)
{
  EntropyRectification<PointNormal> rectification;
  for (std::size_t i = 0; i < clouds.size(); ++i)
    rectification.addPointCloud(clouds[i], odometry[i]);
  rectification.compute();
  return rectification;
}

PlaneAdjustment<PointXYZRGBSigma>
adjusted(const Recording& recording)
{
  PlaneAdjustment<PointXYZRGBSigma> adjustment;
  for (std::size_t i = 0; i < recording.clouds.size(); ++i)
    adjustment.addPointCloud(pointsOf<PointXYZRGBSigma>(*recording.clouds[i]),
                             recording.odometry[i]);
  adjustment.compute();
  return adjustment;
}

/** The whole chain. */
struct Mapped {
  CompactMap map;
  double error = 0; ///< metres, the largest of a pose
  std::string told; ///< outcome of the rectification
};

/** \param[in] adjusts in space, too (`--6dof`); otherwise as the path tells */
Mapped
mapOf(const Recording& recording, bool adjusts = false)
{
  CompactMapping mapping;
  if (adjusts)
    mapping.setAdjust(true);
  for (std::size_t i = 0; i < recording.clouds.size(); ++i)
    mapping.addObservation(recording.clouds[i], recording.odometry[i]);
  Mapped mapped;
  mapping.compute(mapped.map);
  mapped.error = errorOf(mapped.map.trajectory.poses, recording.truth);
  if (const auto& rectification = mapping.getReport().rectification)
    mapped.told =
        rectification_outcome_names[static_cast<std::size_t>(rectification->outcome)];
  return mapped;
}

/** The six axes and a tilted one, each as the direction that is up. */
std::vector<std::pair<std::string, Vector3d>>
upDirections()
{
  const double tilt = 20 * degree;
  return {{"-y", -Vector3d::UnitY()},
          {"z", Vector3d::UnitZ()},
          {"-z", -Vector3d::UnitZ()},
          {"y", Vector3d::UnitY()},
          {"x", Vector3d::UnitX()},
          {"20 degrees from z", Vector3d(std::sin(tilt), 0, std::cos(tilt))}};
}

void
printAxes()
{
  printHead(
      "scene, up | poses given, m | EntropyRectification: up | largest error, m | "
      "PlaneAdjustment, m | MapLevelling: tilt left, deg | "
      "CompactMapping: largest error, m | planes | rooms | area, m2");
  for (const char* const scene : {"office", "l_corridor"}) {
    const Recording given = recordingOf(scene, 24, 2);
    std::vector<std::shared_ptr<PointCloud<PointNormal>>> clouds;
    for (const auto& cloud : given.clouds)
      clouds.push_back(withNormals(*cloud));
    for (const auto& [name, up] : upDirections()) {
      const Recording recording =
          turned(smallestRotation(-Vector3d::UnitY(), up).toRotationMatrix(), given);
      const EntropyRectification<PointNormal> rectification =
          rectified(clouds, recording.odometry);
      MapLevelling<PointNormal> levelling;
      for (std::size_t i = 0; i < clouds.size(); ++i)
        levelling.addPointCloud(clouds[i], recording.truth[i]);
      levelling.compute();
      // the axis that is vertical afterwards is one of those of the frame
      const double tilt =
          std::acos(
              std::min((levelling.getRotation() * up).cwiseAbs().maxCoeff(), 1.0)) /
          degree;
      const Mapped mapped = mapOf(recording);
      const FloorPlan plan = makeFloorPlan(mapped.map);
      double area = 0;
      for (const PlanRoom& room : plan.rooms)
        area += room.area;
      const auto& report = rectification.getReport();
      Row() << std::string(scene) + ", " + name
            << figure(errorOf(recording.odometry, recording.truth), 3)
            << (!report.is_up_found            ? "assumed"
                : report.up.dot(up) > 1 - 1e-3 ? "found"
                                               : "**wrong**")
            << figure(errorOf(posesOf(rectification, clouds.size()), recording.truth),
                      3)
            << figure(errorOf(posesOf(adjusted(recording), clouds.size()),
                              recording.truth),
                      3)
            << figure(tilt, 2) << figure(mapped.error, 3) << mapped.map.planes.size()
            << plan.rooms.size() << figure(area, 1);
    }
  }
}

void
printFrames()
{
  printHead("scene, frame | planes | cylinders | recesses | boxes | rooms | openings | "
            "largest error, m | poses apart from those as given, mm | rectification");
  for (const char* const scene : {"office", "l_corridor", "corridor"}) {
    const Recording given = recordingOf(scene, 24, 1);
    Poses poses;
    const auto print = [&](const std::string& name, const Recording& recording) {
      const Mapped mapped = mapOf(recording);
      if (poses.empty())
        poses = mapped.map.trajectory.poses;
      const FloorPlan plan = makeFloorPlan(mapped.map);
      Row() << scene + (", " + name) << mapped.map.planes.size()
            << mapped.map.cylinders.size() << mapped.map.recesses.size()
            << mapped.map.boxes.size() << plan.rooms.size() << plan.openings.size()
            << figure(mapped.error, 3)
            << figure(1000 * errorOf(mapped.map.trajectory.poses, poses), 3)
            << mapped.told;
    };
    print("as given", given);
    for (const int quarters : {1, 2, 3})
      print("turned by " + std::to_string(90 * quarters),
            turned(Matrix3d(Eigen::AngleAxisd(quarters * M_PI / 2, Vector3d::UnitY())),
                   given));
    print("turned by 33",
          turned(Matrix3d(Eigen::AngleAxisd(33 * degree, Vector3d::UnitY())), given));
    print("mirrored", mirrored(given));
  }
}

/** The corridor of a robot with a scanner of 17 rings: boxes along both walls; y points down. */
test::BoxedHall
boxedCorridor()
{
  constexpr double length = 18, half_width = 1, floor = 0.8;
  test::BoxedHall corridor{
      {Vector3d(-half_width, floor - 2.5, 0), Vector3d(half_width, floor, length)}, {}};
  Random random(11);
  for (double z = 1.25; z < length; z += 2.5)
    for (const double side : {-1.0, 1.0}) {
      const double width = 0.3 + 0.3 * random.uniform();
      const double depth = 0.3 + 0.3 * random.uniform();
      const double height = 0.3 + 0.3 * random.uniform();
      corridor.things.emplace_back(
          Vector3d(side > 0 ? half_width - depth : -half_width, floor - height, z),
          Vector3d(side > 0 ? half_width : depth - half_width, floor, z + width));
    }
  return corridor;
}

Recording
sparseRecording(std::uint64_t seed)
{
  constexpr int rings = 17, steps = 720, clouds = 10;
  constexpr double reach = 8, noise = 0.005, apart = 1.7;
  const test::BoxedHall corridor = boxedCorridor();
  Random random(seed);
  Recording recording;
  for (int i = 0; i < clouds; ++i) {
    Isometry3d pose = Isometry3d::Identity();
    pose.translation() << 0, 0, 1 + apart * i;
    PointCloud<PointXYZ> cloud;
    for (int step = 0; step < steps; ++step)
      for (int ring = 0; ring < rings; ++ring) {
        const double turn = 2 * M_PI * step / steps, rise = (3 * ring - 24) * degree;
        const Vector3d ray(std::cos(rise) * std::sin(turn) + 1e-12,
                           -std::sin(rise) + 1e-12,
                           std::cos(rise) * std::cos(turn) + 1e-12);
        const double range = corridor.range(pose.translation(), ray);
        if (range > reach)
          continue;
        PointXYZ point;
        point.getVector3fMap() =
            ((range + noise * random.normal()) * ray).cast<float>();
        cloud.push_back(point);
      }
    const auto file = std::make_shared<PointCloudFile>();
    toPCLPointCloud2(cloud, file->cloud);
    recording.clouds.push_back(file);
    recording.truth.push_back(pose);
  }
  recording.odometry = drifted(recording.truth, 0.01, 0.03, 1.02, seed);
  return recording;
}

void
printSparse()
{
  printHead("seed | poses given, m | EntropyRectification, m | it tells | expected "
            "error, m | PlaneAdjustment, m | VisualOdometry: posed | largest error, m "
            "| CompactMapping, m | the same, adjusted, m");
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Recording recording = sparseRecording(seed);
    const std::size_t size = recording.clouds.size();
    std::vector<std::shared_ptr<PointCloud<PointNormal>>> clouds;
    PlaneAdjustment<PointXYZ> adjustment;
    for (std::size_t i = 0; i < size; ++i) {
      clouds.push_back(withNormals(*recording.clouds[i]));
      adjustment.addPointCloud(pointsOf<PointXYZ>(*recording.clouds[i]),
                               recording.odometry[i]);
    }
    adjustment.compute();
    const EntropyRectification<PointNormal> rectification =
        rectified(clouds, recording.odometry);
    const VisualOdometryResult odometry =
        VisualOdometry().compute(ObservationSequence(recording.clouds));
    Poses found, truth;
    for (std::size_t i = 0; i < size; ++i)
      if (odometry.poses[i]) {
        found.push_back(*odometry.poses[i]);
        truth.push_back(recording.truth[i]);
      }
    const auto& report = rectification.getReport();
    Row() << seed << figure(errorOf(recording.odometry, recording.truth), 3)
          << figure(errorOf(posesOf(rectification, size), recording.truth), 3)
          << rectification_outcome_names[static_cast<std::size_t>(report.outcome)]
          << figure(report.expected_error ? *report.expected_error : no_reach, 3)
          << atMost(errorOf(posesOf(adjustment, size), recording.truth), 0.1, 3)
          << found.size() << figure(found.empty() ? no_reach : errorOf(found, truth), 3)
          << atMost(mapOf(recording).error, 0.1, 3)
          << atMost(mapOf(recording, true).error, 0.1, 3);
  }
}

/** Poses of a carried laser by its scans alone, beside those of its authors' odometry. */
void
printScans()
{
  const std::optional<ObservationSequence> scans = loadLaserScans();
  if (!scans)
    return;
  printHead("every | scans | posed | aligned ATE, m | steps: translation, mm, rms | "
            "rotation, degrees, rms | CPU s a scan");
  for (const std::size_t every : {std::size_t{1}, std::size_t{2}, std::size_t{3}}) {
    std::vector<std::shared_ptr<const PointCloudFile>> clouds;
    Poses given;
    for (std::size_t i = 0; i < scans->size(); i += every) {
      const PosedObservation scan = scans->load(i);
      clouds.push_back(scan.file);
      given.push_back(scan.T_map_camera);
    }
    VisualOdometryResult odometry;
    const Cost cost = measureCost(
        [&] { odometry = VisualOdometry().compute(ObservationSequence(clouds)); });
    Poses found, truth;
    for (std::size_t i = 0; i < clouds.size(); ++i)
      if (odometry.poses[i]) {
        found.push_back(*odometry.poses[i]);
        truth.push_back(given[i]);
      }
    if (found.size() < 3)
      continue;
    const RelativePoseError steps = relativePoseError(found, truth);
    Row() << every << clouds.size() << found.size()
          << figure(absoluteTrajectoryError(found, truth).aligned, 3)
          << figure(milli * steps.translation_rms, 1)
          << figure(steps.rotation_rms / degree, 2)
          << figure(cost.cpu / static_cast<double>(clouds.size()), 2);
  }
}

const Section axes_section("axes", printAxes);
const Section frames_section("frames", printFrames);
const Section sparse_section("sparse", printSparse);
const Section scans_section("scans", printScans);

} // namespace
} // namespace pcl::acmap::bench
