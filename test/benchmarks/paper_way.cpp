#include "bench.h"
#include "bench_data.h"
#include "paper_runs.h"
#include "run_tool.h"
#include "temporary_folder.h"

#include <pcl/pipeline/observation_files.h>

#include <cstdlib>
#include <map>

namespace pcl::acmap::bench {
namespace {

/** \param[in] variable of the environment */
std::size_t
numberOf(const char* variable, std::size_t usual)
{
  const char* const told = std::getenv(variable);
  return told ? std::strtoul(told, nullptr, 10) : usual;
}

/** The first ones of each input are mapped. */
const std::size_t max_observations = numberOf("ACMAP_OBSERVATIONS", 6);

/** Maximum where raw points are meshed: above it every second, fourth ... is taken. */
const std::size_t max_raw_points = numberOf("ACMAP_RAW_POINTS", 60000);

/** Ours with another step from points to planes. */
PaperWay
ourPlanes(const char* name,
          const std::function<void(PlaneMapping& planes)>& change,
          bool meshes_raw = false)
{
  return {name, spacetime, meshes_raw, [change](CompactMapping& mapping) {
            PlaneMapping planes = mapping.getPlaneMapping();
            change(planes);
            mapping.setPlaneMapping(planes);
          }};
}

const std::vector<PaperWay>&
paperWays()
{
  constexpr auto nothing = [](CompactMapping&) {};
  static const std::vector<PaperWay> ways = {
      {"the paper's way", median_of_shots, true, setPaperWay},
      {"the paper's way, unlit", unlit, true, setPaperWay},
      {"ours", spacetime, false, nothing},
      {"ours, median of the disparities", median_of_shots, false, nothing},
      {"ours, paper's egomotion", spacetime, false, setPaperEgomotion},
      {"ours, paper's rectification", spacetime, false, setPaperRectification},
      ourPlanes(
          "ours, no consolidation",
          [](PlaneMapping& planes) {
            planes.setConsolidationPolicy(ConsolidationPolicy::Never);
          },
          true),
      ourPlanes("ours, strict mesh",
                [](PlaneMapping& planes) {
                  const auto dewall =
                      std::make_shared<DeWallTriangulation<PlaneMapping::Vertex>>();
                  dewall->setAcceptanceRule(DeWallRule::Strict);
                  planes.setMeshConstruction(dewall);
                }),
      ourPlanes("ours, paper's votes",
                [](PlaneMapping& planes) {
                  PlaneMapping::Voting voting;
                  voting.setPaperMode(true);
                  planes.setVoting(voting);
                }),
      ourPlanes("ours, literal hypotheses",
                [](PlaneMapping& planes) {
                  PlaneMapping::Clustering clustering;
                  clustering.setNoiseDriven(false);
                  planes.setClustering(clustering);
                }),
      {"ours, colours of points",
       spacetime,
       false,
       [](CompactMapping& mapping) {
         CompactMapping::Texturing texturing;
         texturing.setPaperMode(true);
         mapping.setTexturing(texturing);
       }},
      {"ours, unlit", unlit, false, nothing}};
  return ways;
}

void
printWayHead()
{
  printHead("way | planes found | spurious | angle, degrees | offset, mm | ATE, cm | "
            "cover, m² | seconds | compactness | each n-th point");
}

void
printRow(const PaperWay& way,
         const PaperWayRun& run,
         double stereo_seconds,
         const PaperWayScores& scores)
{
  Row row;
  row << way.name;
  if (!run.failure.empty()) {
    row << run.failure;
    for (int column = 0; column < 5; ++column)
      row << "";
    row << figure(stereo_seconds + run.seconds, 1) << ""
        << "";
    return;
  }
  row << std::to_string(scores.found) + " of " + std::to_string(scores.planes)
      << scores.spurious << figure(scores.angle, 3) << figure(milli * scores.offset, 1)
      << figure(centi * scores.ate, 1) << figure(scores.cover, 1)
      << figure(stereo_seconds + run.seconds, 1)
      << std::to_string(std::lround(run.compactness)) + " : 1" << run.every;
}

void
printScene(const std::string& scene)
{
  const test::TemporaryFolder folder;
  const std::string session = folder.path("session");
  test::runTool(ACMAP_SIMULATED_RIG,
                {"-o",
                 session,
                 "--scene",
                 scene,
                 "--observations",
                 std::to_string(max_observations)})
      .succeeded();
  const SessionTruth truth = loadSessionTruth(session);
  std::map<std::string, double> stereo_seconds; // by option
  printWayHead();
  for (const PaperWay& way : paperWays()) {
    const std::string observations = folder.path(way.stereo);
    if (stereo_seconds.count(way.stereo) == 0) {
      stereo_seconds[way.stereo] =
          measureCost([&] {
            test::runTool(ACMAP_ACTIVE_STEREO,
                          {session, "-o", observations, way.stereo})
                .succeeded();
          }).wall;
    }
    const PaperWayRun run =
        runPaperWay(way,
                    ObservationSequence(observationPaths(observations)),
                    false,
                    max_raw_points);
    printRow(way,
             run,
             stereo_seconds[way.stereo],
             run.failure.empty() ? scoresOf(run, truth) : PaperWayScores());
  }
}

const Section survey_section("corridor_survey", [] { printScene("corridor_survey"); });

const Section office_section("office", [] { printScene("office"); });

const Section kitchen_section("kitchen", [] {
  const auto recording = pathOfKitchen();
  if (!recording)
    return;
  const test::TemporaryFolder folder;
  const std::string posed = folder.path("posed");
  test::runTool(ACMAP_RGBD_IMPORT, {*recording, "-o", posed}).succeeded();
  std::vector<std::string> files = observationPaths(posed);
  files.resize(std::min(files.size(), max_observations));
  std::vector<Eigen::Isometry3d> given =
      loadTrajectory(posed + "/trajectory.txt").poses;
  given.resize(files.size());
  CompactMapping mapping;
  mapping.setRectify(false);
  mapping.setInputSequence(ObservationSequence(files), true);
  CompactMap reference;
  mapping.compute(reference);
  printWayHead();
  for (const PaperWay& way : paperWays()) {
    if (way.stereo == unlit || (way.stereo != spacetime && !way.meshes_raw))
      continue; // the depth is not that of our stereo
    const PaperWayRun run =
        runPaperWay(way, ObservationSequence(files), true, max_raw_points);
    printRow(way,
             run,
             0,
             run.failure.empty() ? scoresOf(run, reference, given) : PaperWayScores());
  }
});

} // namespace
} // namespace pcl::acmap::bench
