#include "input_cases.h"
#include "ugly_tools.h"

namespace pcl::acmap::test {
namespace {

using Outcomes = std::map<std::string, UglyOutcome>;

const UglyOutcome done;
const UglyOutcome as_they_came = {0, "the poses are as they came"};
const UglyOutcome another_missing = {0, "has 2 poses, the folder 1"};
const std::string last_file = "`obs/observation_0001.pcd` ";
const std::string poses_file = "`obs/trajectory.txt` ";

CommandFor
into(const std::string& output)
{
  return [output](const std::string& input) {
    return std::vector<std::string>{input, "-o", output};
  };
}

} // namespace

UglyTool
uglyEntropyRectification()
{
  const Outcomes outcomes = {
      {last_file + "is not there", another_missing},
      {poses_file + "is not there", done},
      {nan_observation, {0, "observation_0001.pcd: has no point"}},
      {nan_observations, {4, "obs: has no point"}},
      {one_pixel, as_they_came},
      {doubled_observation, done},
      {millimetre_observations, {0, "looks like millimetres"}},
      {odd_folder, done}};
  return {"pcl_entropy_rectification",
          "straight",
          true,
          false,
          sequenceCases(into("straight"), outcomes)};
}

UglyTool
uglyVisualEgomotion()
{
  const UglyOutcome no_stamps = {0, "stamps are numbers"};
  const Outcomes outcomes = {
      {last_file + "is not there", {4, "obs/observation_0000.pcd: is the only"}},
      {poses_file + "is not there", done},
      {poses_file + "has no byte", no_stamps},
      {poses_file + "ends half-way", no_stamps},
      {poses_file + "holds random bytes", no_stamps},
      {poses_file + "is a pipe that nobody writes to", no_stamps},
      {poses_file + "is a folder", no_stamps},
      {"a pose without a number", no_stamps},
      {nan_observation, {4, "observation_0001.pcd has no point"}},
      {nan_observations, {4, "observation_0000.pcd has no point"}},
      {one_pixel, {4, "observation_0001.pcd shows nothing"}},
      {doubled_observation, done},
      {vast_observations, {4, "cannot be metres"}},
      {millimetre_observations, {4, "looks like millimetres"}},
      {odd_folder, done}};
  return {
      "pcl_visual_egomotion", "way", true, false, sequenceCases(into("way"), outcomes)};
}

} // namespace pcl::acmap::test
