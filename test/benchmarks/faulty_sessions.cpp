#include "faulty_sessions.h"

#include "bench.h"
#include "run_tool.h"

#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/pipeline/observation_files.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <regex>

namespace pcl::acmap::bench {

namespace {

namespace fs = std::filesystem;

/** The scene with a smaller camera. */
std::string
smallSceneOf(const std::string& scene)
{
  std::ifstream file(fs::path(ACMAP_SCENES) / (scene + ".yaml"));
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return std::regex_replace(
      text,
      std::regex("\nsensor:[^\n]*\n"),
      "\nsensor: {reach: 6, points: 20000}\n"
      "rig: {width: 240, height: 180, focal_length: 195, center_x: 119.5, center_y: "
      "89.5, "
      "baseline_horizontal: -0.1, baseline_vertical: -0.1, disparity_sigma: 0.2}\n");
}

Trajectory
drifted(const Trajectory& truth, const RecordingFault& fault, int seed)
{
  constexpr double share = 0.01, floor = 0.001, turn = 0.1 * degree;
  Trajectory trajectory = truth;
  std::mt19937 random(static_cast<unsigned>(seed)), once(static_cast<unsigned>(seed));
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-std::sqrt(3.0), std::sqrt(3.0));
  // Bounded, of deviation 1, so that no seed is an odometry that nobody would use.
  const Eigen::Vector3d shared_shift(uniform(once), 0, uniform(once));
  const double shared_turn = uniform(once);
  for (std::size_t i = 1; i < truth.poses.size(); ++i) {
    Eigen::Isometry3d step = truth.poses[i - 1].inverse() * truth.poses[i];
    const double sigma = share * step.translation().norm() + floor;
    step.translation() +=
        sigma * (fault.drift * Eigen::Vector3d(normal(random), 0, normal(random)) +
                 fault.bias * shared_shift);
    step.rotate(Eigen::AngleAxisd(
        turn * (fault.drift * normal(random) + fault.bias * shared_turn),
        Eigen::Vector3d::UnitY()));
    trajectory.poses[i] = trajectory.poses[i - 1] * step;
  }
  return trajectory;
}

/** Index of the largest wall of a session. */
std::size_t
largestWall(const SessionTruth& truth)
{
  constexpr double upright = 0.1;
  std::size_t largest = 0, points = 0;
  for (std::size_t plane = 0; plane < truth.planes.size(); ++plane)
    if (std::abs(truth.planes[plane].coefficients[1]) < upright &&
        truth.planes[plane].points > points) {
      largest = plane;
      points = truth.planes[plane].points;
    }
  return largest;
}

/** Half of the wall is glass: most of its rays end nowhere, the others 2 m behind it. */
class Glass {
public:
  Glass(const SessionTruth& truth, int seed)
  : wall_(largestWall(truth))
  , random_(static_cast<unsigned>(seed))
  {
    const Eigen::Vector4d plane = truth.planes[wall_].coefficients;
    normal_ = plane.head<3>();
    along_ = normal_.cross(Eigen::Vector3d::UnitY());
    double sum = 0;
    for (const Eigen::Isometry3d& pose : truth.trajectory.poses)
      sum += along_.dot(pose.translation());
    middle_ = sum / static_cast<double>(truth.trajectory.poses.size());
  }

  void
  letThrough(PCLPointCloud2& cloud, const Eigen::Isometry3d& T_map_camera)
  {
    constexpr double share_behind = 0.3, depth = 2; // metres
    const auto* const label = findField(cloud, "label", PCLPointField::UINT32);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (std::size_t i = 0; label && i < std::size_t{cloud.width} * cloud.height; ++i) {
      std::uint8_t* const row = cloud.data.data() + i * cloud.point_step;
      std::uint32_t its = 0;
      std::memcpy(&its, row + label->offset, sizeof its);
      Eigen::Vector3f point;
      std::memcpy(point.data(), row, sizeof point);
      const Eigen::Vector3d place = T_map_camera * point.cast<double>();
      if (its != wall_ + 1 || !point.allFinite() || along_.dot(place) < middle_)
        continue;
      const Eigen::Vector3d ray = place - T_map_camera.translation();
      const double facing = std::abs(ray.dot(normal_));
      if (uniform(random_) < share_behind && facing > 0.1)
        point *= static_cast<float>(1 + depth / facing);
      else
        point.setConstant(std::numeric_limits<float>::quiet_NaN());
      std::memcpy(row, point.data(), sizeof point);
    }
  }

private:
  std::size_t wall_;
  Eigen::Vector3d normal_, along_;
  double middle_ = 0;
  std::mt19937 random_;
};

void
scale(PCLPointCloud2& cloud, double factor)
{
  for (std::size_t i = 0; i < std::size_t{cloud.width} * cloud.height; ++i) {
    Eigen::Vector3f point;
    std::uint8_t* const row = cloud.data.data() + i * cloud.point_step;
    std::memcpy(point.data(), row, sizeof point);
    point *= static_cast<float>(factor);
    std::memcpy(row, point.data(), sizeof point);
  }
}

} // namespace

MappedTrajectory
mappedTrajectory(const CompactMap& map, const SessionTruth& truth)
{
  MappedTrajectory mapped;
  for (std::size_t i = 0; i < map.trajectory.poses.size(); ++i) {
    const auto& stamps = truth.trajectory.stamps;
    const auto nearest =
        std::min_element(stamps.begin(), stamps.end(), [&](double a, double b) {
          const double stamp = map.trajectory.stamps[i];
          return std::abs(a - stamp) < std::abs(b - stamp);
        });
    mapped.observations.push_back(static_cast<std::size_t>(nearest - stamps.begin()));
    mapped.before.push_back(map.trajectory.poses[i]);
    mapped.after.push_back(map.trajectory.poses[i]);
  }
  return mapped;
}

void
simulateSession(const std::string& folder,
                const std::string& scene,
                int seed,
                bool is_small,
                std::size_t observations)
{
  std::string chosen = scene;
  if (is_small) {
    chosen = folder + ".yaml";
    std::ofstream(chosen) << smallSceneOf(scene);
  }
  std::vector<std::string> arguments = {
      "-o", folder, "--scene", chosen, "--seed", std::to_string(seed), "--clouds"};
  if (observations > 0)
    for (const std::string& argument :
         {std::string("--observations"), std::to_string(observations)})
      arguments.push_back(argument);
  test::runTool(ACMAP_SIMULATED_RIG, arguments).succeeded();
}

void
writeFaulty(const std::string& folder,
            const std::string& session,
            const RecordingFault& fault,
            int seed)
{
  const SessionTruth truth = loadSessionTruth(session);
  fs::create_directories(folder);
  Trajectory trajectory = drifted(truth.trajectory, fault, seed);
  for (Eigen::Isometry3d& pose : trajectory.poses)
    pose.translation() *= fault.pose_scale;
  std::vector<fs::path> clouds;
  for (const auto& entry : fs::directory_iterator(session))
    if (entry.path().extension() == ".pcd")
      clouds.push_back(entry.path());
  std::sort(clouds.begin(), clouds.end());
  const std::size_t missing =
      static_cast<std::size_t>(fault.gap * static_cast<double>(clouds.size()));
  const std::size_t first_missing = (clouds.size() - missing) / 2;
  Glass glass(truth, seed);
  Trajectory kept;
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    if (i >= first_missing && i < first_missing + missing)
      continue;
    kept.poses.push_back(trajectory.poses[i]);
    kept.stamps.push_back(trajectory.stamps[i]);
    const std::string path = (fs::path(folder) / clouds[i].filename()).string();
    if (!fault.has_glass && fault.depth_scale == 1) {
      fs::create_symlink(fs::absolute(clouds[i]), path);
      continue;
    }
    PCLPointCloud2 cloud = loadPointCloud(clouds[i].string()).cloud;
    if (fault.has_glass)
      glass.letThrough(cloud, truth.trajectory.poses[i]);
    scale(cloud, fault.depth_scale);
    savePointCloud(path, cloud);
  }
  saveTrajectory(folder + "/trajectory.txt", kept);
}

} // namespace pcl::acmap::bench
