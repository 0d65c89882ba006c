#include "pose_estimation.h"

#include "egomotion_reports.h"
#include "observation_folder.h"
#include "way_picture.h"

namespace pcl::acmap {

namespace {

/** \brief Without a motion there is no way to write. */
void
requireMotion(const Tool& tool, const ObservationList& list, const EgomotionRun& run)
{
  if (list.size() < 2)
    tool.failWithNothing(list.paths.front() +
                         ": is the only observation; two are needed for a motion");
  if (run.posed() > 0)
    return;
  tool.failWithNothing("no observation could be joined to another; " + list.paths[0] +
                       " " + run.reasonOf(0, list));
}

} // namespace

EgomotionResult
estimatePoses(Tool& tool, const EgomotionOptions& options)
{
  StepTimer timer(tool.report());
  const ObservationList list = listObservations(tool, options.inputs);
  const std::vector<Eigen::Isometry3d> truth = loadTruth(tool, options.truth, list);
  OutputFolder folder(options.output);
  requireFit(folder, list);
  tool.requireReportWritable(list.paths);
  timer.finish("list");

  const EgomotionRun found = runEgomotion(tool, options, list, folder);
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
  requireFit(folder, list); // another run may have come before
  folder.commit();
  timer.finish("write");
  tellRun(tool, options, list, found, comparison);
  tool.tellSeconds();
  tool.tell("folder", options.output);
  return {list, found};
}

} // namespace pcl::acmap
