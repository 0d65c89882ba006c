#include "chain_agreement.h"
#include "markdown_row.h"
#include "paper_way_runs.h"
#include "temporary_folder.h"
#include "test_data.h"
#include "units.h"

#include <pcl/core/trajectory_error.h>
#include <pcl/pipeline/map_comparison.h>
#include <pcl/pipeline/observation_files.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <iostream>
#include <map>
#include <set>

namespace {

using namespace pcl;
using namespace pcl::acmap;
using namespace pcl::acmap::bench;

constexpr char usage[] =
    "Usage: acmap_bench_paper_way [corridor_survey] [office] [kitchen]\n"
    "                             [observations=N] [points=N]\n"
    "Prints as Markdown tables the paper's way, ours, and ours with one departure "
    "from\n"
    "the paper taken back at a time. The first N observations of each input are "
    "mapped;\n"
    "where raw points are meshed, at most so many points of them, each n-th one. The\n"
    "kitchen comes from the folder that ACMAP_TEST_DATA names.\n";

/** Figures of a map that are not those of its run. */
struct PaperWayScores {
  std::string found;        ///< such as "5 of 7"
  std::size_t spurious = 0; ///< planes of the map that are none of the truth
  double angle = 0;         ///< degrees, mean
  double offset = 0;        ///< metres, mean
  double ate = 0;           ///< metres, aligned
  double cover = 0;         ///< of the truth, square metres
};

void
printTable(const std::string& name, const PaperWaySettings& settings)
{
  std::cout << "\n### " << name << ": " << settings.observations
            << " observations, raw meshes of at most " << settings.points
            << " points\n\n";
  printHead({"way",
             "planes found",
             "spurious",
             "angle, degrees",
             "offset, mm",
             "ATE, cm",
             "cover, m²",
             "seconds",
             "compactness",
             "each n-th point"});
}

void
printRow(const PaperWay& way,
         const PaperWayRun& run,
         double stereo_seconds,
         const PaperWayScores& scores)
{
  MarkdownRow row;
  row.text(way.name);
  if (!run.failure.empty()) {
    row.text(run.failure);
    for (int column = 0; column < 5; ++column)
      row.text("");
    row.number(stereo_seconds + run.seconds, 1).text("").text("").print();
    return;
  }
  row.text(scores.found)
      .count(scores.spurious)
      .number(scores.angle, 3)
      .number(milli * scores.offset, 1)
      .number(centi * scores.ate, 1)
      .number(scores.cover, 1)
      .number(stereo_seconds + run.seconds, 1)
      .text(std::to_string(std::lround(run.compactness)) + " : 1")
      .count(run.every)
      .print();
  std::cout.flush();
}

/** Posed observations of a map: the stamps of estimated poses are their numbers. */
std::vector<std::size_t>
placesOf(const CompactMap& map)
{
  std::vector<std::size_t> places;
  for (const double stamp : map.trajectory.stamps)
    places.push_back(static_cast<std::size_t>(std::lround(stamp)));
  return places;
}

PaperWayScores
scoresOf(const PaperWayRun& run, const SessionTruth& truth)
{
  const Trajectory& after = run.map.trajectory;
  const MappedTrajectory way = {placesOf(run.map),
                                run.odometry.poses.size() == after.poses.size()
                                    ? run.odometry.poses
                                    : after.poses,
                                after.poses};
  const MapDeviation main = compareWithTruth(run.map, way, truth).aligned;
  PaperWayScores scores;
  scores.found =
      std::to_string(main.found) + " of " + std::to_string(main.planes.size());
  scores.angle = main.mean_angle;
  scores.offset = main.mean_offset;
  scores.ate = main.ate_after;
  for (const PlaneDeviation& plane : main.planes)
    scores.cover += plane.overlap;
  // a plane is spurious if, alone in a map, it finds none of all true planes
  SessionTruth all = truth;
  for (TruePlane& plane : all.planes)
    plane.points = 1;
  for (const PlanePatch& plane : run.map.planes) {
    CompactMap alone;
    alone.planes = {plane};
    scores.spurious += compareWithTruth(alone, way, all).aligned.found == 0 ? 1 : 0;
  }
  return scores;
}

void
printScene(const std::string& scene, const PaperWaySettings& settings)
{
  const test::TemporaryFolder folder;
  const std::string session = folder.path("session");
  runWhole(ACMAP_SIMULATED_RIG,
           {"-o",
            session,
            "--scene",
            scene,
            "--observations",
            std::to_string(settings.observations)});
  const SessionTruth truth = loadSessionTruth(session);
  std::map<std::string, double> stereo_seconds; // by option
  printTable(scene, settings);
  for (const PaperWay& way : paperWays()) {
    const std::string observations = folder.path(way.stereo);
    if (stereo_seconds.count(way.stereo) == 0) {
      const auto begin = std::chrono::steady_clock::now();
      runWhole(ACMAP_ACTIVE_STEREO, {session, "-o", observations, way.stereo});
      stereo_seconds[way.stereo] =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
              .count();
    }
    const PaperWayRun run = runPaperWay(
        way, ObservationSequence(observationPaths(observations)), false, settings);
    printRow(way,
             run,
             stereo_seconds[way.stereo],
             run.failure.empty() ? scoresOf(run, truth) : PaperWayScores());
  }
}

/** Compares with the map of the given poses, which is made our way. */
PaperWayScores
scoresOf(const PaperWayRun& run,
         const CompactMap& reference,
         const std::vector<Eigen::Isometry3d>& given)
{
  std::vector<ChainView> views;
  std::vector<Eigen::Isometry3d> true_poses;
  const std::vector<std::size_t> places = placesOf(run.map);
  for (std::size_t i = 0; i < places.size(); ++i) {
    true_poses.push_back(given[places[i]]);
    views.push_back({{Eigen::Vector3d::Zero(),
                      Eigen::Vector3d::UnitX(),
                      Eigen::Vector3d::UnitY(),
                      Eigen::Vector3d::UnitZ()},
                     true_poses.back(),
                     run.map.trajectory.poses[i]});
  }
  const Eigen::Isometry3d T_given_found = comparePoints(views).T_given_found;
  const PlaneAgreement planes =
      comparePlanes(reference.planes, run.map.planes, T_given_found);
  double area = 0;
  for (const PlanePatch& plane : reference.planes)
    area += plane.area;
  PaperWayScores scores;
  scores.found =
      std::to_string(planes.planes) + " of " + std::to_string(reference.planes.size());
  scores.spurious =
      run.map.planes.size() -
      comparePlanes(run.map.planes, reference.planes, T_given_found.inverse()).planes;
  scores.angle = planes.angle;
  scores.offset = planes.offset;
  scores.ate = absoluteTrajectoryError(run.map.trajectory.poses, true_poses).aligned;
  scores.cover = planes.area * area;
  return scores;
}

void
printKitchen(const PaperWaySettings& settings)
{
  const std::string recording = "C_sequence/redkitchen_000_495";
  if (!test::hasTestData(recording + "/frame-000000.pose.txt")) {
    std::cout << "\nkitchen: left out, no " << recording << "\n";
    return;
  }
  const test::TemporaryFolder folder;
  const std::string posed = folder.path("posed");
  runWhole(ACMAP_RGBD_IMPORT, {test::testDataPath(recording).string(), "-o", posed});
  std::vector<std::string> files = observationPaths(posed);
  files.resize(std::min(files.size(), settings.observations));
  std::vector<Eigen::Isometry3d> given =
      loadTrajectory(posed + "/trajectory.txt").poses;
  given.resize(files.size());
  CompactMapping mapping;
  mapping.setRectify(false);
  mapping.setInputSequence(ObservationSequence(files), true);
  CompactMap reference;
  mapping.compute(reference);
  printTable("kitchen", settings);
  for (const PaperWay& way : paperWays()) {
    if (std::string(way.stereo) != "--method=spacetime" && way.meshes_raw == false)
      continue; // the depth is not that of our stereo
    if (std::string(way.stereo) == "--unlit")
      continue;
    const PaperWayRun run =
        runPaperWay(way, ObservationSequence(files), true, settings);
    printRow(way,
             run,
             0,
             run.failure.empty() ? scoresOf(run, reference, given) : PaperWayScores());
  }
}

} // namespace

int
main(int argc, char** argv)
{
  PaperWaySettings settings;
  std::set<std::string> asked;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.rfind("observations=", 0) == 0)
      settings.observations = std::stoul(word.substr(std::strlen("observations=")));
    else if (word.rfind("points=", 0) == 0)
      settings.points = std::stoul(word.substr(std::strlen("points=")));
    else if (word == "corridor_survey" || word == "office" || word == "kitchen")
      asked.insert(word);
    else {
      std::cerr << usage;
      return word == "--help" ? 0 : 2;
    }
  }
  for (const char* scene : {"corridor_survey", "office"})
    if (asked.empty() || asked.count(scene) > 0)
      printScene(scene, settings);
  if (asked.empty() || asked.count("kitchen") > 0)
    printKitchen(settings);
  return 0;
}
