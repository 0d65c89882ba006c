#include "truth_comparison.h"

#include <pcl/pipeline/observation_files.h>

#include <algorithm>

namespace pcl::acmap {

namespace {

std::vector<PlanarPose>
planarPartsOf(const std::vector<Eigen::Isometry3d>& poses)
{
  std::vector<PlanarPose> parts(poses.size());
  std::transform(poses.begin(), poses.end(), parts.begin(), planarPartOf);
  return parts;
}

/** Rows that are only in the same order might belong to other observations. */
void
requireRows(Tool& tool,
            const std::string& path,
            const std::vector<std::string>& names,
            std::size_t rows)
{
  if (rows == names.size())
    return;
  const std::string counts = path + ": has " + std::to_string(rows) + " poses for " +
                             std::to_string(names.size()) + " observations";
  for (const std::string& name : names)
    if (!isNumbered(name))
      throw InputFileException(counts + ", and " + name +
                               " has no number that would tell which is its own");
  tool.warn(counts + "; the numbers in their names tell which");
}

/** Does the true trajectory move? Otherwise errors cannot be given relative to its
 * length. */
bool
isWay(const std::vector<Eigen::Isometry3d>& truth)
{
  constexpr double least = 0.001; // metres
  double length = 0;
  for (std::size_t i = 1; i < truth.size(); ++i)
    length += (truth[i].translation() - truth[i - 1].translation()).norm();
  return length >= least;
}

} // namespace

std::vector<Eigen::Isometry3d>
loadTruth(Tool& tool, const std::string& path, const ObservationList& list)
{
  std::vector<Eigen::Isometry3d> truth;
  if (path.empty())
    return truth;
  const Trajectory trajectory = loadTrajectory(path);
  requireRows(tool, path, list.names, trajectory.poses.size());
  for (const std::size_t row :
       trajectoryRows(path, list.names, trajectory.poses.size())) {
    truth.push_back(trajectory.poses[row]);
    truth.back().translation() *= tool.scale();
  }
  return truth;
}

TruthComparison
compare(std::vector<Eigen::Isometry3d> truth,
        const VisualOdometryResult& run,
        bool is_rigid)
{
  const auto first = std::find_if(run.poses.begin(),
                                  run.poses.end(),
                                  [](const auto& pose) { return pose.has_value(); });
  const Eigen::Isometry3d T_map_world =
      **first * truth[static_cast<std::size_t>(first - run.poses.begin())].inverse();
  std::vector<Eigen::Isometry3d> found, true_of_found;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    truth[i] = T_map_world * truth[i];
    if (!run.poses[i])
      continue;
    found.push_back(*run.poses[i]);
    true_of_found.push_back(truth[i]);
  }
  TruthComparison comparison;
  comparison.truth = std::move(truth);
  comparison.is_way = isWay(true_of_found);
  comparison.relative = relativePoseError(found, true_of_found);
  comparison.absolute =
      is_rigid
          ? absoluteTrajectoryError(found, true_of_found)
          : absoluteTrajectoryError(planarPartsOf(found), planarPartsOf(true_of_found));
  return comparison;
}

} // namespace pcl::acmap
