#include <pcl/core/exceptions.h>
#include <pcl/core/impl/quantile.h>
#include <pcl/core/planar_pose.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/odometry_comparison.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {

namespace {

std::vector<PlanarPose>
planarPartsOfAll(const std::vector<Eigen::Isometry3d>& poses)
{
  std::vector<PlanarPose> parts(poses.size());
  std::transform(poses.begin(), poses.end(), parts.begin(), planarPartOf);
  return parts;
}

/** Metres. */
double
lengthOfPath(const std::vector<Eigen::Isometry3d>& poses)
{
  double length = 0;
  for (std::size_t i = 1; i < poses.size(); ++i)
    length += (poses[i].translation() - poses[i - 1].translation()).norm();
  return length;
}

/** Median of a function over all pairs with a motion. */
template <typename Function>
double
medianOfPairs(const VisualOdometryResult& found, const Function& function)
{
  std::vector<double> values;
  for (const OdometryPair& pair : found.pairs)
    if (pair.estimate)
      values.push_back(static_cast<double>(function(pair)));
  return acmap::medianOf(values);
}

/** \param[in] first,count of the rows of the covariance */
double
medianOfDeviations(const VisualOdometryResult& found, int first, int count)
{
  return medianOfPairs(found, [&](const OdometryPair& pair) {
    return std::sqrt(pair.estimate->covariance.diagonal().segment(first, count).sum());
  });
}

} // namespace

OdometryFigures
figuresOf(const VisualOdometryResult& found)
{
  std::vector<Eigen::Isometry3d> posed;
  for (const auto& pose : found.poses)
    if (pose)
      posed.push_back(*pose);
  OdometryFigures figures;
  figures.length = lengthOfPath(posed);
  figures.matches = medianOfPairs(
      found, [](const OdometryPair& pair) { return pair.report.matches; });
  figures.inliers = medianOfPairs(
      found, [](const OdometryPair& pair) { return pair.report.inliers; });
  for (const OdometryPair& pair : found.pairs)
    figures.fits += pair.report.fits;
  figures.translation = medianOfDeviations(found, 0, 3);
  figures.rotation = medianOfDeviations(found, 3, 3);
  figures.x = medianOfDeviations(found, 0, 1);
  figures.z = medianOfDeviations(found, 2, 1);
  figures.about_y = medianOfDeviations(found, 4, 1);
  return figures;
}

OdometryComparison
compareWithTruth(const VisualOdometryResult& run, std::vector<Eigen::Isometry3d> truth)
{
  const auto first = std::find_if(run.poses.begin(),
                                  run.poses.end(),
                                  [](const auto& pose) { return pose.has_value(); });
  if (first == run.poses.end() || truth.size() != run.poses.size())
    throw acmap::BadArgument("there are ",
                             truth.size(),
                             " true poses for ",
                             run.poses.size(),
                             " observations, of which ",
                             run.posed(),
                             " have a pose");
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
  constexpr double min_length = 0.001; // metres
  return {std::move(truth),
          relativePoseError(found, true_of_found),
          run.model == MotionModel::Rigid
              ? absoluteTrajectoryError(found, true_of_found)
              : absoluteTrajectoryError(planarPartsOfAll(found),
                                        planarPartsOfAll(true_of_found)),
          lengthOfPath(true_of_found) >= min_length};
}

std::vector<Eigen::Isometry3d>
loadTruePoses(const std::string& path,
              const std::vector<std::string>& names,
              double scale,
              std::vector<std::string>& remarks)
{
  const std::vector<Eigen::Isometry3d> rows = loadTrajectory(path).poses;
  if (rows.size() != names.size()) {
    const std::string counts = path + ": has " + std::to_string(rows.size()) +
                               " poses for " + std::to_string(names.size()) +
                               " observations";
    for (const std::string& name : names)
      if (!acmap::isNumbered(name))
        throw InputFileException(counts + ", and " + name +
                                 " has no number that would tell which is its own");
    remarks.push_back(counts + "; the numbers in their names tell which");
  }
  std::vector<Eigen::Isometry3d> truth;
  for (const std::size_t row : acmap::trajectoryRows(path, names, rows.size())) {
    truth.push_back(rows[row]);
    truth.back().translation() *= scale;
  }
  return truth;
}

} // namespace pcl
