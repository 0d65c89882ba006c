#include "figure_inputs.h"

#include <pcl/core/cloud_fields.h>
#include <pcl/core/file_format.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/trajectory_error.h>
#include <pcl/core/yaml_node.h>
#include <pcl/pipeline/observation_files.h>

#include <cmath>
#include <filesystem>

namespace pcl::acmap {

namespace {

constexpr double farthest = 1e6; // metres
constexpr std::size_t most = 1000000;

Eigen::Vector3d
cornerOf(const YamlNode& node)
{
  Eigen::Vector3d corner;
  const auto& values = node.list(3, 3);
  for (std::size_t i = 0; i < values.size(); ++i)
    corner[static_cast<Eigen::Index>(i)] = values[i].number(-farthest, farthest);
  return corner;
}

/** The ends of an upright rectangle: its two corners that are farthest from each other
 * seen from above. */
std::array<Eigen::Vector3d, 2>
endsOf(const YamlNode& rectangle)
{
  std::vector<Eigen::Vector3d> corners;
  for (const YamlNode& corner : rectangle.list(4, 4)) {
    corners.push_back(cornerOf(corner));
    corners.back().y() = 0;
  }
  std::array<Eigen::Vector3d, 2> ends = {corners[0], corners[0]};
  for (const Eigen::Vector3d& a : corners)
    for (const Eigen::Vector3d& b : corners)
      if ((a - b).norm() > (ends[1] - ends[0]).norm())
        ends = {a, b};
  return ends;
}

void
requireThere(const std::string& path, const std::string& advice)
{
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    throw InputFileException(path + ": is not there; " + advice);
}

/** Compares positions, in metres: the map of another session differs by more than any
 * drift. */
void
requireSameWay(const MappedSession& map, const FilmedSession& session)
{
  const std::string what = map.folder + ": is not a map of " + session.folder + ": ";
  if (map.after.poses.size() != session.trajectory.poses.size())
    throw InputFileException(what + "it has " + std::to_string(map.after.poses.size()) +
                             " poses, the session " +
                             std::to_string(session.trajectory.poses.size()));
  constexpr double least = 0.5, share = 0.1;
  double way = 0;
  const auto& truth = session.trajectory.poses;
  for (std::size_t i = 1; i < truth.size(); ++i)
    way += (truth[i].translation() - truth[i - 1].translation()).norm();
  const double error = absoluteTrajectoryError(map.after.poses, truth).unaligned;
  if (!(error <= least + share * way))
    throw InputFileException(what + "its places are " + std::to_string(error) +
                             " m from the true ones");
}

} // namespace

FilmedSession
loadFilmedSession(const std::string& folder)
{
  const std::string path = folder + "/truth.json";
  requireThere(path,
               "the figures need the truth of a session that pcl_simulated_rig filmed");
  const YamlNode truth = loadYaml(path); // JSON is a subset of YAML
  requireFormat(truth, file_formats::truth);
  FilmedSession session;
  session.folder = folder;
  session.scene = truth.at("scene").text();
  session.observations = truth.at("observations").count(1, most);
  session.patterns = truth.at("patterns").count(1, most);
  for (const YamlNode& plane : truth.at("planes").list(1, most)) {
    constexpr double level = 0.7; // cosine
    const auto& coefficients = plane.at("coefficients").list(4, 4);
    if (std::abs(coefficients[1].number(-farthest, farthest)) > level)
      continue;
    for (const YamlNode& rectangle : plane.at("rectangles").list(1, most))
      session.uprights.push_back(endsOf(rectangle));
  }
  session.trajectory = loadTrajectory(folder + "/" + trajectory_name);
  if (session.trajectory.poses.size() != session.observations)
    truth.at("observations").fail("is not the number of poses in trajectory.txt");
  return session;
}

MappedSession
loadMappedSession(const std::string& folder, const FilmedSession& session)
{
  const std::string advice = "make the map by pcl_compact_mapping " + session.folder;
  const auto path = [&](const std::string& name) {
    const std::string whole = folder + "/" + name;
    requireThere(whole, advice);
    return whole;
  };
  MappedSession map;
  map.folder = folder;
  map.after = loadTrajectory(path(trajectory_name));
  map.before = loadTrajectory(path("trajectory_before.txt"));
  if (map.before.poses.size() != map.after.poses.size())
    throw InputFileException(folder +
                             ": trajectory_before.txt and trajectory.txt differ "
                             "in number of poses");
  requireSameWay(map, session);
  const std::string clouds = path("stages/observations");
  for (const std::string& name : observationNames(clouds))
    map.observations.push_back((std::filesystem::path(clouds) / name).string());
  if (map.observations.size() != session.observations)
    throw InputFileException(
        clouds + ": has " + std::to_string(map.observations.size()) +
        " observations, the session " + std::to_string(session.observations));
  map.points = loadPointCloud(path("map.pcd")).cloud;
  if (!findField(map.points, "view", PCLPointField::INT32))
    throw InputFileException(folder + "/map.pcd: has no field view, an integer");
  return map;
}

} // namespace pcl::acmap
