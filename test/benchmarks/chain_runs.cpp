#include "chain_runs.h"

#include "bench.h"
#include "json_file.h"
#include "processes.h"
#include "run_tool.h"

#include <pcl/core/map_file.h>
#include <pcl/core/trajectory.h>

#include <filesystem>
#include <iomanip>

namespace pcl::acmap::bench {

namespace {

std::string
observationIn(const std::string& folder, std::size_t number)
{
  std::ostringstream path;
  path << folder << "/observation_" << std::setw(4) << std::setfill('0') << number
       << ".pcd";
  return path.str();
}

/** The stamps of estimated poses are the numbers of the observations; given poses are
 * in the order of the observations. */
std::vector<ChainView>
viewsOf(const std::string& observations,
        const Trajectory& given,
        const Trajectory& found,
        bool is_given)
{
  std::vector<ChainView> views;
  for (std::size_t i = 0; i < found.poses.size(); ++i) {
    const auto number =
        is_given ? i : static_cast<std::size_t>(std::lround(found.stamps[i]));
    views.push_back({thinnedPoints(loadPointCloud(observationIn(observations, number))),
                     given.poses.at(number),
                     found.poses[i]});
  }
  return views;
}

} // namespace

ChainRun
runChainOfTools(const ChainWay& way,
                const std::string& recording,
                const std::string& folder)
{
  const std::string posed = folder + "/posed", bare = folder + "/bare";
  const std::string made = folder + "/map";
  for (const std::string& old : {posed, bare, made})
    std::filesystem::remove_all(old);
  const std::string every = std::to_string(way.every);
  test::runTool(ACMAP_RGBD_IMPORT, {recording, "-o", posed, "--every", every})
      .succeeded();
  test::runTool(ACMAP_RGBD_IMPORT,
                {recording, "-o", bare, "--every", every, "--no-poses"})
      .succeeded();
  ChainRun result;
  const double begin = childSeconds();
  std::vector<std::string> mapping = {
      way.is_given ? posed : bare, "-o", made, "--no-pictures"};
  if (!way.is_given)
    mapping.emplace_back("--6dof");
  mapping.insert(mapping.end(), way.mapping.begin(), way.mapping.end());
  test::runTool(ACMAP_COMPACT_MAPPING, mapping).succeeded();
  result.seconds = childSeconds() - begin;
  const Trajectory given = loadTrajectory(posed + "/trajectory.txt");
  result.observations = given.poses.size();
  result.views =
      viewsOf(posed, given, loadTrajectory(made + "/trajectory.txt"), way.is_given);
  result.map = loadMapFile(made + "/map.json");
  const nlohmann::json report = test::reportOf(made);
  const nlohmann::json& bytes = report.at("bytes");
  result.compactness =
      bytes.at("raw").get<double>() / bytes.at("map.glb").get<double>();
  result.peak_memory = report.at("peak_memory_bytes");
  return result;
}

} // namespace pcl::acmap::bench
