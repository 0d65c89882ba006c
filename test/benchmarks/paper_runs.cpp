#include "paper_runs.h"

#include "bench.h"
#include "temporary_folder.h"

#include <pcl/core/trajectory_error.h>
#include <pcl/pipeline/map_comparison.h>
#include <pcl/texture/compact_map_folder.h>

#include <filesystem>

namespace pcl::acmap::bench {
namespace {

double
compactnessOf(CompactMap map, std::size_t points)
{
  const test::TemporaryFolder folder;
  saveCompactMap(folder.path(""), map);
  constexpr double bytes_of_point = 16;
  return bytes_of_point * static_cast<double>(points) /
         static_cast<double>(std::filesystem::file_size(folder.path("map.glb")));
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

} // namespace

void
setPaperWay(CompactMapping& mapping)
{
  mapping.setMode(MappingMode::Paper);
  setPaperEgomotion(mapping);
}

void
setPaperEgomotion(CompactMapping& mapping)
{
  VisualOdometry odometry;
  VisualOdometry::Egomotion egomotion;
  egomotion.setPaperMode(true);
  odometry.setEgomotion(egomotion);
  mapping.setVisualOdometry(odometry);
}

void
setPaperRectification(CompactMapping& mapping)
{
  CompactMapping::Rectification rectification = mapping.getRectification();
  rectification.setMode(RectificationMode::Paper);
  mapping.setRectification(rectification);
}

PaperWayRun
runPaperWay(const PaperWay& way,
            const ObservationSequence& observations,
            bool is_rigid,
            std::size_t max_raw_points,
            bool has_poses)
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
  if (way.meshes_raw) {
    ObservationMerging merging = mapping.getMerging();
    merging.setMaximumPoints(max_raw_points);
    mapping.setMerging(merging);
  }
  mapping.setInputSequence(observations, has_poses);
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
  scores.found = main.found;
  scores.planes = main.planes.size();
  scores.angle = main.mean_angle;
  scores.offset = main.mean_offset;
  scores.ate = main.ate_after;
  for (const PlaneDeviation& plane : main.planes) {
    scores.cover += plane.cover;
    if (!plane.finder)
      scores.missing += (scores.missing.empty() ? "" : ", ") + plane.name;
  }
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
  scores.found = planes.planes;
  scores.planes = reference.planes.size();
  scores.spurious =
      run.map.planes.size() -
      comparePlanes(run.map.planes, reference.planes, T_given_found.inverse()).planes;
  scores.angle = planes.angle;
  scores.offset = planes.offset;
  scores.ate = absoluteTrajectoryError(run.map.trajectory.poses, true_poses).aligned;
  scores.cover = planes.area * area;
  return scores;
}

} // namespace pcl::acmap::bench
