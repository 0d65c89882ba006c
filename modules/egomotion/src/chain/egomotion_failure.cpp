#include "chain/egomotion_failure.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace pcl::acmap {

namespace {

constexpr double max_deviation = 0.1;    // metres
constexpr double max_turning = 0.02;     // radians
constexpr double max_contradicted = 0.2; // share

/** \brief Standard deviation in the direction in which it is largest. */
double
largestDeviation(const Eigen::Matrix3d& covariance)
{
  if (!covariance.allFinite())
    return std::numeric_limits<double>::infinity();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance,
                                                              Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(solver.eigenvalues()[2], 0.0));
}

std::string
openText(double length, double turn)
{
  std::ostringstream text;
  text << "what both views show leaves a direction open: standard deviations up to "
       << length << " m and " << turn << " rad, at most " << max_deviation << " m and "
       << max_turning << " rad are taken";
  return text.str();
}

std::string
beyondText(double moved, double turned, const EgomotionSettings& settings)
{
  std::ostringstream text;
  text << "the matches agree on a motion of " << moved << " m and " << turned
       << " rad, at most " << settings.max_translation << " m and "
       << settings.max_rotation << " rad were to be expected";
  return text.str();
}

/** \brief Maximum difference between depths on a ray for points of the same surface, as
 * a share of the depth.
 * \param[in] distance distance of the plane from the camera, metres */
double
mostDifference(const SurfaceBlock& one, const SurfaceBlock& other, double distance)
{
  constexpr double minimum = 0.02;     // relative to the depth
  constexpr double max_deviations = 2; // standard deviations of the noise
  return std::max(minimum,
                  max_deviations * std::sqrt(one.variance + other.variance) /
                      std::abs(distance));
}

/** \brief Share of the blocks of one view that contradict the other view. */
double
shareOf(const EgomotionView& one,
        const EgomotionView& other,
        const Eigen::Isometry3d& T_other_one)
{
  if (!other.pinhole)
    return 0;
  std::size_t agreeing = 0, contradicted = 0;
  for (const SurfaceBlock& block : one.surfaces.blocks) {
    if (!block.isPlane())
      continue;
    const Eigen::Vector3d point = T_other_one * block.point;
    if (point.z() <= 0)
      continue;
    const SurfaceBlock* seen = other.surfaces.at(other.pinhole->project(point));
    if (!seen || !seen->isPlane())
      continue;
    const double depth = seen->normal.dot(seen->center);
    const double behind = seen->normal.dot(point) / depth - 1;
    const double maximum = mostDifference(block, *seen, depth);
    contradicted += behind < -maximum;
    agreeing += std::abs(behind) <= maximum;
  }
  const std::size_t told = agreeing + contradicted;
  return told > 0 ? static_cast<double>(contradicted) / static_cast<double>(told) : 0;
}

} // namespace

bool
isAgreement(std::size_t inliers, std::size_t matches)
{
  constexpr std::size_t never_by_chance = 10;
  return inliers >= min_features &&
         (inliers >= never_by_chance || 2 * inliers >= matches);
}

std::optional<EgomotionFailure>
failureOfView(const EgomotionView& view, const std::string& name, std::size_t needed)
{
  if (view.points == 0)
    return EgomotionFailure{EgomotionOutcome::BlankView, name + " has no point"};
  const std::size_t keypoints = view.keypoints();
  if (keypoints == 0)
    return EgomotionFailure{EgomotionOutcome::BlankView,
                            name + " shows nothing to recognise"};
  if (keypoints < needed)
    return EgomotionFailure{EgomotionOutcome::FewFeatures,
                            name + " has " + std::to_string(keypoints) +
                                " keypoints, at least " + std::to_string(needed) +
                                " are needed"};
  return std::nullopt;
}

std::optional<EgomotionFailure>
failureOfMotion(const EgomotionEstimate& estimate,
                double contradicted,
                const EgomotionSettings& settings)
{
  const double length = largestDeviation(estimate.covariance.topLeftCorner<3, 3>());
  const double turn = largestDeviation(estimate.covariance.bottomRightCorner<3, 3>());
  if (!(length <= max_deviation) || !(turn <= max_turning))
    return EgomotionFailure{EgomotionOutcome::Unobservable, openText(length, turn)};
  if (contradicted > max_contradicted)
    return EgomotionFailure{EgomotionOutcome::Inconsistent,
                            std::to_string(std::lround(100 * contradicted)) +
                                " % of the surfaces contradict the motion"};
  const double moved = estimate.T_target_source.translation().norm();
  const double turned = Eigen::AngleAxisd(estimate.T_target_source.linear()).angle();
  if (moved > settings.max_translation || turned > settings.max_rotation)
    return EgomotionFailure{EgomotionOutcome::Inconsistent,
                            beyondText(moved, turned, settings)};
  return std::nullopt;
}

double
contradictedShare(const EgomotionView& source,
                  const EgomotionView& target,
                  const Eigen::Isometry3d& T_target_source)
{
  return std::max(shareOf(source, target, T_target_source),
                  shareOf(target, source, T_target_source.inverse()));
}

} // namespace pcl::acmap
