#include "pose_estimation.h"

#include "egomotion_reports.h"
#include "length_check.h"
#include "match_picture.h"
#include "way_picture.h"

#include <pcl/core/cloud_fields.h>
#include <pcl/pipeline/observation_files.h>

namespace pcl::acmap {

namespace {

/** Throws if there is no motion, and therefore no trajectory to write. */
void
requireMotion(const Tool& tool,
              const ObservationList& list,
              const VisualOdometryResult& run)
{
  const std::string& first = list.sequence.path(0);
  if (list.sequence.size() < 2)
    tool.failWithNothing(first +
                         ": is the only observation; two are needed for a motion");
  if (run.posed() == 0)
    tool.failWithNothing("no observation could be joined to another; " + first + " " +
                         run.reasonOf(0, list.names));
}

VisualOdometry::Egomotion
egomotionOf(const EgomotionOptions& options)
{
  constexpr double pi = 3.14159265358979323846;
  VisualOdometry::Egomotion egomotion;
  egomotion.setMotionModel(options.is_rigid ? MotionModel::Rigid : MotionModel::Planar);
  egomotion.setMaximumKeypoints(options.keypoints);
  egomotion.setRefinement(options.refines);
  egomotion.setMaximumTranslation(options.max_translation);
  egomotion.setMaximumRotation(options.max_rotation * pi / 180);
  return egomotion;
}

/** Draws the matches of each observation with the one that it was joined to; for a lost
 * one, those with the previous observation. */
VisualOdometry::PairCallback
matchDrawer(const OutputFolder& folder)
{
  return [&folder, drawn = std::optional<std::size_t>()](
             const OdometryPair& pair,
             const VisualOdometry::Egomotion& egomotion) mutable {
    if (pair.estimate || drawn != pair.now)
      savePng(folder.path(numberedName("matches", pair.now, ".png")),
              matchPicture(*egomotion.getInputSource(),
                           *egomotion.getInputTarget(),
                           egomotion.getMatches(),
                           egomotion.getInliers()));
    drawn = pair.now;
  };
}

VisualOdometryResult
run(Tool& tool,
    const EgomotionOptions& options,
    const ObservationList& list,
    const OutputFolder& folder)
{
  VisualOdometry odometry;
  odometry.setEgomotion(egomotionOf(options));
  odometry.setNumberOfThreads(tool.threads());
  if (options.pictures)
    odometry.setPairCallback(matchDrawer(folder));
  if (options.writes_observations)
    odometry.setPoseCallback([&](std::size_t index,
                                 const PointCloudFile& observation,
                                 const Eigen::Isometry3d& T_map_camera) {
      PCLPointCloud2 cloud = observation.cloud;
      dropUnwritableFields(cloud);
      saveObservation(folder.path(list.outputs[index]), cloud, T_map_camera);
    });
  warnOfLengths(tool, *list.sequence.load(0).file);
  VisualOdometryResult found;
  tool.withProgress([&](const ProgressCallback& progress) {
    odometry.setProgressCallback(progress);
    found = odometry.compute(list.sequence);
  });
  return found;
}

} // namespace

void
estimatePoses(Tool& tool,
              const EgomotionOptions& options,
              const std::optional<ObservationSequence>& opened)
{
  StepTimer timer(tool.report());
  const ObservationList list = listObservations(tool, options.inputs, opened);
  const std::vector<Eigen::Isometry3d> truth = loadTruth(tool, options.truth, list);
  OutputFolder folder(options.output);
  requireFit(folder, list.sequence);
  tool.requireReportWritable(list.sequence.paths());
  timer.finish("list");

  const VisualOdometryResult found = run(tool, options, list, folder);
  warnOfFreeMotion(tool, found);
  requireMotion(tool, list, found);
  timer.finish("estimate");

  std::optional<TruthComparison> comparison;
  if (!truth.empty())
    comparison = compare(truth, found, options.is_rigid);
  pcl::saveTrajectory(folder.path(trajectory_name), found.trajectory(list.stamps));
  savePng(
      folder.path("plan.png"),
      wayPicture(found.poses,
                 comparison ? comparison->truth : std::vector<Eigen::Isometry3d>()));
  tool.stopIfInterrupted();
  // another run may have written into the folder meanwhile
  requireFit(folder, list.sequence);
  folder.commit();
  timer.finish("write");
  tellRun(tool, options, list, found, comparison);
  tool.tellSeconds();
  tool.tell("folder", options.output);
}

} // namespace pcl::acmap
