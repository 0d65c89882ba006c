#include <pcl/core/exceptions.h>
#include <pcl/core/file_format.h>
#include <pcl/core/impl/yaml_node.h>
#include <pcl/core/output_file.h>
#include <pcl/pipeline/estimated_poses.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <locale>
#include <sstream>

namespace pcl {

namespace {

namespace fs = std::filesystem;

constexpr const char* poses_name = "poses.yaml";

std::string
textOf(const EstimatedPoses& poses)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  text << "format: " << acmap::file_formats::poses << '\n';
  if (poses.noise)
    text << "odometry_noise: [" << poses.noise->length << ", "
         << poses.noise->length_per_metre << ", " << poses.noise->turn << ", "
         << poses.noise->turn_per_radian << "]\n";
  if (poses.up)
    text << "up: [" << poses.up->x() << ", " << poses.up->y() << ", " << poses.up->z()
         << "]\n";
  if (poses.verdict)
    text << "verdict: " << acmap::nameIn(acmap::verdict_outcome_names, *poses.verdict)
         << '\n';
  text << "observations:\n";
  for (const std::size_t place : poses.places)
    text << "  - " << place << '\n';
  return text.str();
}

OdometryNoise
noiseIn(const acmap::YamlNode& node)
{
  constexpr double maximum = 1e6;
  const std::vector<acmap::YamlNode>& values = node.list(4, 4);
  return {values[0].number(0, maximum),
          values[1].number(0, maximum),
          values[2].number(0, maximum),
          values[3].number(0, maximum)};
}

Eigen::Vector3d
upIn(const acmap::YamlNode& node)
{
  const std::vector<acmap::YamlNode>& values = node.list(3, 3);
  return {values[0].number(-1, 1), values[1].number(-1, 1), values[2].number(-1, 1)};
}

VerdictOutcome
verdictIn(const acmap::YamlNode& node)
{
  const auto& names = acmap::verdict_outcome_names;
  const auto* const name = std::find(names.begin(), names.end(), node.text());
  if (name == names.end())
    node.fail("is no verdict: " + node.text());
  return static_cast<VerdictOutcome>(name - names.begin());
}

} // namespace

void
saveEstimatedPoses(const std::string& folder, const EstimatedPoses& poses)
{
  if (poses.places.size() != poses.trajectory.poses.size())
    throw acmap::BadArgument("there are ",
                             poses.trajectory.poses.size(),
                             " poses for ",
                             poses.places.size(),
                             " observations");
  const std::string text = textOf(poses);
  saveTrajectory((fs::path(folder) / acmap::trajectory_name).string(),
                 poses.trajectory);
  acmap::OutputFile file((fs::path(folder) / poses_name).string());
  file.write(text.data(), text.size());
  file.commit();
}

std::optional<EstimatedPoses>
loadEstimatedPoses(const std::string& folder)
{
  const std::string path = (fs::path(folder) / poses_name).string();
  std::error_code error;
  if (!fs::exists(path, error))
    return std::nullopt;
  const acmap::YamlNode document = acmap::loadYaml(path);
  acmap::requireFormat(document, acmap::file_formats::poses);
  document.requireKeys(
      {"format", "made_of", "odometry_noise", "up", "verdict", "observations"});
  EstimatedPoses poses;
  constexpr std::size_t maximum = 10000000;
  std::size_t next = 0;
  for (const acmap::YamlNode& place : document.at("observations").list(1, maximum)) {
    poses.places.push_back(place.count(next, maximum));
    next = poses.places.back() + 1;
  }
  if (const acmap::YamlNode* noise = document.find("odometry_noise"))
    poses.noise = noiseIn(*noise);
  if (const acmap::YamlNode* up = document.find("up"))
    poses.up = upIn(*up);
  if (const acmap::YamlNode* verdict = document.find("verdict"))
    poses.verdict = verdictIn(*verdict);
  const fs::path trajectory = fs::path(folder) / acmap::trajectory_name;
  poses.trajectory = loadTrajectory(trajectory.string());
  if (poses.trajectory.poses.size() != poses.places.size())
    throw InputFileException(path + ": names " + std::to_string(poses.places.size()) +
                             " observations, " + acmap::trajectory_name + " has " +
                             std::to_string(poses.trajectory.poses.size()) + " poses");
  return poses;
}

} // namespace pcl
