#include "bench.h"
#include "faulty_sessions.h"
#include "run_tool.h"
#include "temporary_folder.h"

#include <pcl/core/map_file.h>
#include <pcl/core/plane_distance.h>
#include <pcl/pipeline/map_comparison.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

// The told accuracy of distances between planes of maps whose poses were drifted, and then rectified,
// against the truth.

namespace pcl::acmap::bench {
namespace {

/** A distance between two planes of a map. */
struct Told {
  double error;        ///< metres
  double deviation;    ///< metres, as told
  double noise;        ///< the same of the noise of the planes alone
  double distance;     ///< metres, true
  bool is_equal;       ///< Are the true normals equal, or opposite?
  std::string planes;  ///< names of both
  std::string drift{}; ///< its kind
};

const TruePlane&
planeNamed(const SessionTruth& truth, const std::string& name)
{
  return *std::find_if(truth.planes.begin(),
                       truth.planes.end(),
                       [&](const auto& plane) { return plane.name == name; });
}

/** All pairs of parallel true planes that the map has. */
std::vector<Told>
distancesOf(const std::string& folder, const std::string& session)
{
  const SessionTruth truth = loadSessionTruth(session);
  CompactMap map = loadMapFile(folder + "/map.json");
  CompactMap of_noise = map;
  for (std::size_t p = 0; p < of_noise.planes.size(); ++p)
    for (const Eigen::Vector3d& mode : map.planes[p].pose_modes)
      of_noise.planes[p].covariance -= mode * mode.transpose();
  for (PlanePatch& plane : of_noise.planes)
    plane.pose_modes.clear();
  std::vector<Told> told;
  const std::vector<PlaneDeviation> planes =
      compareWithTruth(map, mappedTrajectory(map, truth), truth).aligned.planes;
  for (std::size_t a = 0; a < planes.size(); ++a)
    for (std::size_t b = a + 1; b < planes.size(); ++b) {
      if (!planes[a].finder || !planes[b].finder)
        continue;
      const Eigen::Vector4d one = planeNamed(truth, planes[a].name).coefficients,
                            other = planeNamed(truth, planes[b].name).coefficients;
      const double cosine = one.head<3>().dot(other.head<3>());
      constexpr double parallel = 1 - 1e-9;
      if (std::abs(cosine) < parallel || *planes[a].finder == *planes[b].finder)
        continue;
      const double truly = std::abs(one[3] - (cosine > 0 ? 1 : -1) * other[3]);
      constexpr double least = 0.02; // metres; less is one plane
      if (truly < least)
        continue;
      const PlaneDistance found =
          distanceBetween(map, *planes[a].finder, *planes[b].finder);
      told.push_back(
          {found.distance - truly,
           found.deviation,
           distanceBetween(of_noise, *planes[a].finder, *planes[b].finder).deviation,
           truly,
           cosine > 0,
           planes[a].name + " and " + planes[b].name});
    }
  return told;
}

/** Root mean square of the errors in told deviations. */
double
normalised(const std::vector<Told>& told, double Told::*deviation)
{
  double sum = 0;
  for (const Told& one : told)
    sum += std::pow(one.error / (one.*deviation), 2);
  return std::sqrt(sum / static_cast<double>(told.size()));
}

void
addRow(const std::string& name, const std::vector<Told>& told)
{
  if (told.empty())
    return;
  const auto errors =
      valuesOf(told, [](const Told& one) { return std::abs(one.error); });
  const auto within = std::count_if(told.begin(), told.end(), [](const Told& one) {
    return std::abs(one.error) <= 2 * one.deviation;
  });
  Row() << name << told.size() << figure(1000 * median(errors), 2)
        << figure(1000 * median(valuesOf(
                             told, [](const Told& one) { return one.deviation; })),
                  2)
        << figure(normalised(told, &Told::noise), 1)
        << figure(normalised(told, &Told::deviation), 2)
        << figure(percent(static_cast<std::size_t>(within), told.size()), 0);
}

double
numberOf(const char* name, double otherwise)
{
  const char* const text = std::getenv(name);
  return text ? std::atof(text) : otherwise;
}

std::vector<std::string>
wordsOf(const char* name, const std::string& otherwise)
{
  const char* const text = std::getenv(name);
  std::istringstream words(text ? text : otherwise);
  return {std::istream_iterator<std::string>(words), {}};
}

/** Drift of one kind: "random", independent from step to step; "bias", which all steps share; or
 * "both". */
RecordingFault
driftOf(const std::string& kind)
{
  const double factor = numberOf("ACMAP_DISTANCE_DRIFT", 1);
  RecordingFault fault{kind};
  if (kind != "bias")
    fault.drift = factor;
  if (kind != "random")
    fault.bias = factor;
  return fault;
}

/** The pairs of a group of maps or of distances. */
struct Group {
  std::string name;
  std::function<bool(const Told&)> has;
};

/** Groups that do not depend on the scene. */
std::vector<Group>
groupsOf(const std::vector<std::string>& kinds)
{
  std::vector<Group> groups;
  for (const std::string& kind : kinds)
    groups.push_back(
        {"drift: " + kind, [kind](const Told& one) { return one.drift == kind; }});
  groups.push_back({"equal normals", [](const Told& one) { return one.is_equal; }});
  groups.push_back({"opposite normals", [](const Told& one) { return !one.is_equal; }});
  constexpr double near = 0.5, far = 5; // metres
  groups.push_back(
      {"below 0.5 m", [](const Told& one) { return one.distance < near; }});
  groups.push_back({"0.5 to 5 m", [](const Told& one) {
                      return one.distance >= near && one.distance < far;
                    }});
  groups.push_back({"from 5 m", [](const Told& one) { return one.distance >= far; }});
  groups.push_back({"all", [](const Told&) { return true; }});
  return groups;
}

/** Maps what was filmed in a scene, with one draw of the drift. */
std::vector<Told>
distancesOfMap(const std::string& session, const std::string& kind, int seed)
{
  const test::TemporaryFolder folder;
  const std::string views = folder.path("views"), map = folder.path("map");
  writeFaulty(views, session, driftOf(kind), seed);
  std::vector<std::string> arguments = {
      views, "-o", map, "--no-pictures", "--formats", "svg"};
  for (const std::string& option : wordsOf("ACMAP_DISTANCE_OPTIONS", ""))
    arguments.push_back(option);
  test::runTool(ACMAP_COMPACT_MAPPING, arguments).succeeded();
  std::vector<Told> told = distancesOf(map, session);
  for (Told& one : told)
    one.drift = kind;
  return told;
}

/** Appends the pairs of a map to the file that ACMAP_DISTANCE_PAIRS names. */
void
savePairs(const std::vector<Told>& told, const std::string& scene, int seed)
{
  const char* const path = std::getenv("ACMAP_DISTANCE_PAIRS");
  if (!path)
    return;
  std::ofstream file(path, std::ios::app);
  for (const Told& one : told)
    file << scene << "," << one.drift << "," << seed << "," << one.planes << ","
         << one.distance << "," << one.error << "," << one.deviation << "\n";
}

/** Maps scenes (ACMAP_DISTANCE_SCENES) of ACMAP_DISTANCE_SEEDS seeds (default 3) from
 * ACMAP_DISTANCE_SEED (default 1) on, with each kind of drift (ACMAP_DISTANCE_KINDS). With
 * ACMAP_DISTANCE_SMALL=1 the images are small, which takes a quarter of the time. The tool gets
 * ACMAP_DISTANCE_OPTIONS, too. */
void
printDistances()
{
  const auto first = static_cast<int>(numberOf("ACMAP_DISTANCE_SEED", 1));
  const int end = first + static_cast<int>(numberOf("ACMAP_DISTANCE_SEEDS", 3));
  const bool is_small = numberOf("ACMAP_DISTANCE_SMALL", 0) > 0;
  const std::vector<std::string> kinds =
      wordsOf("ACMAP_DISTANCE_KINDS", "random bias both");
  printHead("scene | pairs | median error, mm | median told, mm | "
            "normalised, without modes | normalised | within 2 deviations, %");
  std::vector<Told> all;
  for (const std::string& scene :
       wordsOf("ACMAP_DISTANCE_SCENES",
               "room office l_corridor loop corridor_survey corridor_drive "
               "l_corridor_drive")) {
    std::vector<Told> of_scene;
    for (int seed = first; seed < end; ++seed) {
      const test::TemporaryFolder folder;
      const std::string session = folder.path("session");
      simulateSession(session, scene, seed, is_small);
      for (const std::string& kind : kinds) {
        const std::vector<Told> told = distancesOfMap(session, kind, seed);
        savePairs(told, scene, seed);
        of_scene.insert(of_scene.end(), told.begin(), told.end());
      }
    }
    addRow(scene, of_scene);
    all.insert(all.end(), of_scene.begin(), of_scene.end());
  }
  for (const Group& group : groupsOf(kinds)) {
    std::vector<Told> chosen;
    std::copy_if(all.begin(), all.end(), std::back_inserter(chosen), group.has);
    addRow(group.name, chosen);
  }
}

const Section distances_section("distances", printDistances);

} // namespace
} // namespace pcl::acmap::bench
