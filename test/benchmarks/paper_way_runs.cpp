#include "paper_way_runs.h"

#include "temporary_folder.h"
#include "timing.h"

#include <pcl/texture/compact_map_folder.h>

#include <algorithm>
#include <filesystem>

namespace pcl::acmap::bench {
namespace {

constexpr const char *spacetime = "--method=spacetime",
                     *median_of_shots = "--method=median", *unlit = "--unlit";

void
setPaper(CompactMapping& mapping)
{
  mapping.setMode(MappingMode::Paper);
}

void
setNothing(CompactMapping&)
{}

template <typename Change>
void
changePlanes(CompactMapping& mapping, const Change& change)
{
  PlaneMapping planes = mapping.getPlaneMapping();
  change(planes);
  mapping.setPlaneMapping(planes);
}

void
setEgomotion(CompactMapping& mapping)
{
  VisualOdometry odometry;
  VisualOdometry::Egomotion egomotion;
  egomotion.setPaperMode(true);
  odometry.setEgomotion(egomotion);
  mapping.setVisualOdometry(odometry);
}

void
setRectification(CompactMapping& mapping)
{
  CompactMapping::Rectification rectification = mapping.getRectification();
  rectification.setMode(RectificationMode::Paper);
  mapping.setRectification(rectification);
}

void
setRaw(CompactMapping& mapping)
{
  changePlanes(mapping, [](PlaneMapping& planes) {
    planes.setConsolidationPolicy(ConsolidationPolicy::Never);
  });
}

void
setStrict(CompactMapping& mapping)
{
  changePlanes(mapping, [](PlaneMapping& planes) {
    const auto dewall = std::make_shared<DeWallTriangulation<PlaneMapping::Vertex>>();
    dewall->setAcceptanceRule(DeWallRule::Strict);
    planes.setMeshConstruction(dewall);
  });
}

void
setVotes(CompactMapping& mapping)
{
  changePlanes(mapping, [](PlaneMapping& planes) {
    PlaneMapping::Voting voting;
    voting.setPaperMode(true);
    planes.setVoting(voting);
  });
}

void
setHypotheses(CompactMapping& mapping)
{
  changePlanes(mapping, [](PlaneMapping& planes) {
    PlaneMapping::Clustering clustering;
    clustering.setNoiseDriven(false);
    planes.setClustering(clustering);
  });
}

void
setTexture(CompactMapping& mapping)
{
  CompactMapping::Texturing texturing;
  texturing.setPaperMode(true);
  mapping.setTexturing(texturing);
}

double
compactnessOf(CompactMap map, std::size_t points)
{
  const test::TemporaryFolder folder;
  saveCompactMap(folder.path(""), map);
  constexpr double bytes_of_point = 16;
  return bytes_of_point * static_cast<double>(points) /
         static_cast<double>(std::filesystem::file_size(folder.path("map.glb")));
}

} // namespace

const std::vector<PaperWay>&
paperWays()
{
  static const std::vector<PaperWay> ways = {
      {"the paper's way", median_of_shots, true, setPaper},
      {"the paper's way, unlit", unlit, true, setPaper},
      {"ours", spacetime, false, setNothing},
      {"ours, median of the disparities", median_of_shots, false, setNothing},
      {"ours, paper's egomotion", spacetime, false, setEgomotion},
      {"ours, paper's rectification", spacetime, false, setRectification},
      {"ours, no consolidation", spacetime, true, setRaw},
      {"ours, strict mesh", spacetime, false, setStrict},
      {"ours, paper's votes", spacetime, false, setVotes},
      {"ours, literal hypotheses", spacetime, false, setHypotheses},
      {"ours, colours of points", spacetime, false, setTexture},
      {"ours, unlit", unlit, false, setNothing}};
  return ways;
}

PaperWayRun
runPaperWay(const PaperWay& way,
            const ObservationSequence& observations,
            bool is_rigid,
            const PaperWaySettings& settings)
{
  CompactMapping mapping;
  if (is_rigid) {
    VisualOdometry odometry;
    VisualOdometry::Egomotion egomotion;
    egomotion.setMotionModel(MotionModel::Rigid);
    odometry.setEgomotion(egomotion);
    mapping.setVisualOdometry(odometry);
  }
  way.change(mapping);
  if (way.change == setPaper)
    setEgomotion(mapping); // planar, whatever the motion is
  if (way.meshes_raw) {
    ObservationMerging merging = mapping.getMerging();
    merging.setMaximumPoints(settings.points);
    mapping.setMerging(merging);
  }
  mapping.setInputSequence(observations, false);
  PaperWayRun run;
  try {
    run.seconds = measureCost([&] { mapping.compute(run.map); }).wall;
    const CompactMappingReport& report = mapping.getReport();
    run.odometry = mapping.getOdometryTrajectory();
    run.every = report.merging.every;
    if (run.map.planes.empty())
      run.failure = "no plane";
    else
      run.compactness =
          compactnessOf(run.map, report.merging.points * report.merging.every);
  }
  catch (const PCLException&) {
    run.failure = "no map: no observation could be joined to another one";
  }
  return run;
}

} // namespace pcl::acmap::bench
