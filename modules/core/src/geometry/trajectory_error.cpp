#include <pcl/core/impl/quantile.h>
#include <pcl/core/trajectory_error.h>

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/rigid_alignment.h>
#include <pcl/core/trajectory.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace pcl {

namespace {

/** Positions of a trajectory, one per column, in space or on the floor. */
template <int Dimension>
using Places = Eigen::Matrix<double, Dimension, Eigen::Dynamic>;

template <typename Pose>
void
requireSameNumber(const std::vector<Pose>& found, const std::vector<Pose>& truth)
{
  if (found.size() != truth.size())
    throw acmap::BadArgument(std::to_string(found.size()) +
                             " poses cannot be compared with " +
                             std::to_string(truth.size()) + " true ones");
}

void
requireRigid(const std::vector<Eigen::Isometry3d>& poses, const std::string& whose)
{
  for (std::size_t i = 0; i < poses.size(); ++i)
    if (!isRigid(poses[i]))
      throw acmap::BadArgument(whose + " pose " + std::to_string(i) +
                               " is no rigid motion");
}

/** Error of a rigid motion. */
MotionError
errorOf(const Eigen::Isometry3d& found, const Eigen::Isometry3d& truth)
{
  const Eigen::Isometry3d rest = truth.inverse() * found;
  return {rest.translation().norm(),
          Eigen::AngleAxisd(rest.linear()).angle(),
          truth.translation().norm()};
}

double
meanOf(const std::vector<MotionError>& errors,
       const std::function<double(const MotionError&)>& value)
{
  double sum = 0;
  for (const MotionError& error : errors)
    sum += value(error);
  return sum / static_cast<double>(errors.size());
}

double
medianOrUnknown(std::vector<double>& values)
{
  return values.empty() ? std::numeric_limits<double>::quiet_NaN()
                        : acmap::medianOf(values);
}

template <int Dimension>
double
rootMeanSquare(const Places<Dimension>& differences)
{
  return std::sqrt(differences.colwise().squaredNorm().mean());
}

template <int Dimension>
AbsoluteTrajectoryError
trajectoryErrorOf(const Places<Dimension>& found, const Places<Dimension>& truth)
{
  if (found.cols() == 0 || !found.allFinite() || !truth.allFinite())
    throw acmap::BadArgument("a trajectory has no poses, or one that is not finite");
  const Places<Dimension> from = found.colwise() - found.rowwise().mean();
  const Places<Dimension> to = truth.colwise() - truth.rowwise().mean();
  return {rootMeanSquare<Dimension>(found - truth),
          rootMeanSquare<Dimension>(
              acmap::alignmentRotation<Dimension>(to * from.transpose()) * from - to)};
}

Places<3>
placesOf(const std::vector<Eigen::Isometry3d>& poses)
{
  Places<3> places(3, static_cast<Eigen::Index>(poses.size()));
  for (std::size_t i = 0; i < poses.size(); ++i)
    places.col(static_cast<Eigen::Index>(i)) = poses[i].translation();
  return places;
}

Places<2>
placesOf(const std::vector<PlanarPose>& poses)
{
  Places<2> places(2, static_cast<Eigen::Index>(poses.size()));
  for (std::size_t i = 0; i < poses.size(); ++i)
    places.col(static_cast<Eigen::Index>(i)) << poses[i].x, poses[i].z;
  return places;
}

} // namespace

MotionError
motionError(const Eigen::Isometry3d& found, const Eigen::Isometry3d& truth)
{
  if (!isRigid(found) || !isRigid(truth))
    throw acmap::BadArgument("what is no rigid motion cannot be compared");
  return errorOf(found, truth);
}

RelativePoseError
summaryOf(const std::vector<MotionError>& errors)
{
  std::vector<double> translations, rotations, shares;
  RelativePoseError summary;
  summary.pairs = errors.size();
  for (const MotionError& error : errors) {
    translations.push_back(error.translation);
    rotations.push_back(error.rotation);
    if (error.length > 0)
      shares.push_back(error.translation / error.length);
  }
  summary.rotation_worst = rotations.empty()
                               ? std::numeric_limits<double>::quiet_NaN()
                               : *std::max_element(rotations.begin(), rotations.end());
  const auto translation = [](const MotionError& error) { return error.translation; };
  const auto rotation = [](const MotionError& error) { return error.rotation; };
  const auto squareOf = [](const auto& value) {
    return [value](const MotionError& error) { return std::pow(value(error), 2); };
  };
  summary.translation_rms = std::sqrt(meanOf(errors, squareOf(translation)));
  summary.translation_median = medianOrUnknown(translations);
  summary.rotation_rms = std::sqrt(meanOf(errors, squareOf(rotation)));
  summary.rotation_median = medianOrUnknown(rotations);
  const double length =
      meanOf(errors, [](const MotionError& error) { return error.length; });
  summary.translation_per_metre = length > 0 ? meanOf(errors, translation) / length
                                             : std::numeric_limits<double>::quiet_NaN();
  summary.translation_per_metre_median = medianOrUnknown(shares);
  return summary;
}

RelativePoseError
relativePoseError(const std::vector<Eigen::Isometry3d>& found,
                  const std::vector<Eigen::Isometry3d>& truth,
                  std::size_t step)
{
  requireSameNumber(found, truth);
  if (step == 0)
    throw acmap::BadArgument("step = 0 is refused: a pose moves from another one");
  requireRigid(found, "found");
  requireRigid(truth, "true");
  std::vector<MotionError> errors;
  for (std::size_t i = step; i < found.size(); ++i)
    errors.push_back(errorOf(found[i - step].inverse() * found[i],
                             truth[i - step].inverse() * truth[i]));
  return summaryOf(errors);
}

AbsoluteTrajectoryError
absoluteTrajectoryError(const std::vector<Eigen::Isometry3d>& found,
                        const std::vector<Eigen::Isometry3d>& truth)
{
  requireSameNumber(found, truth);
  return trajectoryErrorOf<3>(placesOf(found), placesOf(truth));
}

AbsoluteTrajectoryError
absoluteTrajectoryError(const std::vector<PlanarPose>& found,
                        const std::vector<PlanarPose>& truth)
{
  requireSameNumber(found, truth);
  return trajectoryErrorOf<2>(placesOf(found), placesOf(truth));
}

} // namespace pcl
