#include "bench.h"
#include "faulty_sessions.h"
#include "run_tool.h"
#include "temporary_folder.h"

#include <pcl/core/map_file.h>
#include <pcl/core/plane_distance.h>
#include <pcl/pipeline/map_comparison.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

// The told accuracy of distances between planes of maps whose poses were drifted, and then rectified,
// against the truth.

namespace pcl::acmap::bench {
namespace {

/** A distance between two planes of a map. */
struct Told {
  double error;     ///< metres
  double deviation; ///< metres, as told
  double noise;     ///< the same of the noise of the planes alone
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
           distanceBetween(of_noise, *planes[a].finder, *planes[b].finder).deviation});
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

/** Maps scenes of ACMAP_DISTANCE_SEEDS seeds (default 3) from ACMAP_DISTANCE_SEED (default 1) on. */
void
printDistances()
{
  const auto number = [](const char* name, int otherwise) {
    const char* const text = std::getenv(name);
    return text ? std::atoi(text) : otherwise;
  };
  printHead("scene | pairs | median error, mm | median told, mm | "
            "normalised, without modes | normalised | within 2 deviations, %");
  std::vector<Told> all;
  const char* const drift = std::getenv("ACMAP_DISTANCE_DRIFT");
  const int first = number("ACMAP_DISTANCE_SEED", 1);
  for (const char* scene : {"room", "office", "l_corridor", "loop", "corridor_survey"})
    for (int seed = first; seed < first + number("ACMAP_DISTANCE_SEEDS", 3); ++seed) {
      const test::TemporaryFolder folder;
      const std::string session = folder.path("session"), views = folder.path("views"),
                        map = folder.path("map");
      simulateSession(session, scene, seed, false);
      writeFaulty(views, session, {"drift", drift ? std::atof(drift) : 1}, seed);
      test::runTool(ACMAP_COMPACT_MAPPING,
                    {views, "-o", map, "--no-pictures", "--formats", "svg"})
          .succeeded();
      const std::vector<Told> told = distancesOf(map, session);
      addRow(scene + (" " + std::to_string(seed)), told);
      all.insert(all.end(), told.begin(), told.end());
    }
  addRow("all", all);
}

const Section distances_section("distances", printDistances);

} // namespace
} // namespace pcl::acmap::bench
