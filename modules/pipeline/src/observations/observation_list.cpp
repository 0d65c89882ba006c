#include <pcl/core/map_file.h>
#include <pcl/core/output_file.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/observation_list.h>

#include <filesystem>
#include <fstream>
#include <numeric>
#include <utility>
#include <vector>

namespace pcl {

namespace {

namespace fs = std::filesystem;

/** The path in a folder, or the absolute path of a file that is elsewhere. */
std::string
listedPath(const std::string& file, const fs::path& folder)
{
  const fs::path path = fs::weakly_canonical(fs::absolute(file));
  const fs::path inside = path.lexically_relative(folder);
  const bool is_inside = !inside.empty() && *inside.begin() != "..";
  return (is_inside ? inside : path).string();
}

/** \throws InputFileException if there is no list, or it is too long for one */
std::vector<std::string>
readLines(const std::string& path)
{
  constexpr std::uintmax_t max_bytes = std::uintmax_t{64} << 20;
  std::error_code error;
  if (!fs::is_regular_file(path, error))
    throw InputFileException(path + ": is missing; only maps of observations that are "
                                    "files can be extended");
  if (const auto bytes = fs::file_size(path, error); error || bytes > max_bytes)
    throw InputFileException(path + ": is no list of observations");
  std::ifstream stream(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
    if (!line.empty())
      lines.push_back(line);
  return lines;
}

} // namespace

void
saveObservationList(const std::string& path,
                    const std::string& map,
                    const ObservationSequence& sequence)
{
  const fs::path folder = fs::weakly_canonical(fs::absolute(map));
  std::string lines;
  for (const std::string& file : sequence.paths())
    lines += listedPath(file, folder) + "\n";
  acmap::OutputFile output(path);
  output.write(lines.data(), lines.size());
  output.commit();
}

ObservationSequence
openMappedObservations(const std::string& map)
{
  const std::string list = (fs::path(map) / observation_list_name).string();
  std::vector<std::string> files;
  for (const std::string& line : readLines(list))
    files.push_back((fs::path(map) / line).string());
  Trajectory trajectory =
      loadTrajectory((fs::path(map) / acmap::trajectory_name).string());
  if (files.empty() || files.size() != trajectory.poses.size())
    throw InputFileException(list + ": names " + std::to_string(files.size()) +
                             " observations, " + acmap::trajectory_name + " has " +
                             std::to_string(trajectory.poses.size()) + " poses");
  std::error_code error;
  for (const std::string& file : files)
    if (!fs::exists(file, error))
      throw InputFileException(file + ": is missing, an observation of the map " + map);
  std::vector<std::size_t> places(files.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  const std::string planes = (fs::path(map) / "map.json").string();
  const Eigen::Vector3d shift =
      fs::exists(planes, error) ? loadMapFile(planes).shift : Eigen::Vector3d::Zero();
  return ObservationSequence(std::move(files))
      .withPoses(places, std::move(trajectory))
      .withShift(shift);
}

} // namespace pcl
