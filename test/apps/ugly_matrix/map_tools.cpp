#include "input_cases.h"
#include "small_world.h"
#include "ugly_tools.h"

namespace pcl::acmap::test {
namespace {

using Outcomes = std::map<std::string, UglyOutcome>;

const UglyOutcome fine;
const std::string missing_observation = "`obs/observation_0001.pcd` is not there";
const std::string missing_poses = "`obs/trajectory.txt` is not there";
const UglyOutcome poses_left_over = {0, "has 2 poses, the folder 1"};

void
giveMapFile(const TemporaryFolder& folder)
{
  give(folder, hallMap() + "/map.json", "planes.json");
}

/** Results of pcl_compact_mapping for each kind of input. */
Outcomes
outcomesOfClouds()
{
  return {{nan_points, {4, "nan.pcd"}},
          {one_point, {4, "one.pcd"}},
          {doubled_points, {0, "repeat the place"}},
          {vast_points, {4, "cannot be metres"}},
          {far_points, {4, "in steps of"}},
          {millimetre_points, {6, "looks like millimetres"}},
          {odd_cloud, {0, "no observation has colour"}}};
}

Outcomes
outcomesOfSequences()
{
  return {{missing_observation, poses_left_over},
          {missing_poses, fine},
          {nan_observation, {0, "observation_0001.pcd: has no point"}},
          {nan_observations, {4, "obs: has no point"}},
          {one_pixel, {0, "the poses are as they came"}},
          {doubled_observation, fine},
          {millimetre_observations, {6, "looks like millimetres"}},
          {odd_folder, fine}};
}

} // namespace

UglyTool
uglyCompactMapping()
{
  // texels so fine that a map in millimetres does not fit into any memory
  const auto command = [](const std::string& input) {
    return std::vector<std::string>{
        input, "-o", "map", "--no-pictures", "--texel", "0.005"};
  };
  CaseList list({}, {}, {});
  list.addAll(cloudCases(command, outcomesOfClouds()));
  list.addAll(sequenceCases(command, outcomesOfSequences()));
  Outcomes of_sessions = sessionOutcomes();
  of_sessions[odd_folder] = {0, "where the sensors stood is unknown"};
  list.addAll(sessionCases(command, of_sessions));
  return {"pcl_compact_mapping", "map", true, false, list.cases()};
}

UglyTool
uglyPlaneTexturing()
{
  const auto command = [](const std::string& observations) {
    return std::vector<std::string>{"planes.json", observations, "-o", "map"};
  };
  const Outcomes outcomes = {{missing_observation, poses_left_over},
                             {missing_poses, fine},
                             {nan_observation, fine},
                             {nan_observations, {0, "no observation saw a plane"}},
                             {one_pixel, fine},
                             {doubled_observation, fine},
                             {vast_observations, {0, "cannot be metres"}},
                             {millimetre_observations, {0, "looks like millimetres"}},
                             {odd_folder, fine}};
  const auto good = [](const TemporaryFolder& folder) {
    giveMapFile(folder);
    give(folder, hallObservations(), "obs");
  };
  CaseList list(good, command("obs"), {});
  list.addFile("planes.json");
  list.add(Ugliness::WrongFields,
           "`planes.json` without coefficients",
           "planes.json",
           [](const auto& folder) {
             replaceIn(folder.path("planes.json"), "coefficients", "coefs");
           });
  list.addAll(sequenceCases(command, outcomes, giveMapFile));
  return {"pcl_plane_texturing", "map", true, false, list.cases()};
}

} // namespace pcl::acmap::test
