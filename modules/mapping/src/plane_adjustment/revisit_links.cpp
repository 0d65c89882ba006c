#include "revisit_links.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::acmap {
namespace {

// Systematic errors of views, which their covariance does not contain.
constexpr double least_shift = 0.01; // metres
constexpr double least_turn = 0.003; // radians

/** Bound of a squared residual: three standard deviations in each of six directions. */
constexpr double max_squared = 6 * 9;

/** Covariance of the residual of a revisit's motion. */
Matrix6
residualCovariance(const RevisitConstraint& revisit)
{
  const Eigen::Vector3d way = revisit.T_earlier_later.translation();
  Matrix6 of_motion = Matrix6::Zero(); // translation, rotation to rotation, translation
  of_motion.topRightCorner<3, 3>() = revisit.T_earlier_later.linear().transpose();
  of_motion.bottomLeftCorner<3, 3>().setIdentity();
  of_motion.bottomRightCorner<3, 3>() << 0, way.z(), -way.y(), -way.z(), 0, way.x(),
      way.y(), -way.x(), 0;
  Vector6 variances;
  variances.head<3>().setConstant(least_turn * least_turn);
  variances.tail<3>().setConstant(least_shift * least_shift);
  return of_motion * revisit.covariance * of_motion.transpose() +
         Matrix6(variances.asDiagonal());
}

} // namespace

RevisitLinks::RevisitLinks(const std::vector<RevisitConstraint>& revisits)
{
  for (const RevisitConstraint& revisit : revisits) {
    const Matrix6 covariance = residualCovariance(revisit);
    links_.push_back({revisit.earlier,
                      revisit.later,
                      revisit.T_earlier_later,
                      covariance,
                      covariance.llt().solve(Matrix6::Identity())});
  }
}

void
RevisitLinks::addPairs(std::vector<PoseSystem::Pair>& pairs) const
{
  for (const Link& link : links_)
    if (link.earlier > 0)
      pairs.emplace_back(link.earlier - 1, link.later - 1);
}

double
RevisitLinks::cost(const Poses& poses) const
{
  double cost = 0;
  for (const Link& link : links_) {
    const Vector6 r =
        motionResidual(link.motion, poses[link.earlier].inverse() * poses[link.later]);
    cost += r.dot(link.information * r);
  }
  return cost;
}

void
RevisitLinks::linearize(const Poses& poses,
                        PoseSystem& system,
                        std::vector<Vector6>& gradient) const
{
  Matrix6 before, after;
  for (const Link& link : links_) {
    const Eigen::Isometry3d motion = poses[link.earlier].inverse() * poses[link.later];
    motionJacobians(link.motion, motion, before, after);
    const Vector6 weighted = link.information * motionResidual(link.motion, motion);
    const std::size_t later = link.later - 1;
    system.add(later, later, after.transpose() * link.information * after);
    gradient[later] += after.transpose() * weighted;
    if (link.earlier > 0) {
      const std::size_t earlier = link.earlier - 1;
      system.add(earlier, earlier, before.transpose() * link.information * before);
      system.add(later, earlier, after.transpose() * link.information * before);
      gradient[earlier] += before.transpose() * weighted;
    }
  }
}

void
RevisitLinks::dropImplausible(const Poses& poses, const PoseSystem& inverse)
{
  std::vector<Link> plausible;
  Matrix6 before, after;
  for (const Link& link : links_) {
    const Eigen::Isometry3d motion = poses[link.earlier].inverse() * poses[link.later];
    motionJacobians(link.motion, motion, before, after);
    const std::size_t later = link.later - 1;
    Matrix6 covariance =
        link.covariance + after * inverse.inverse(later, later) * after.transpose();
    if (link.earlier > 0) {
      const std::size_t earlier = link.earlier - 1;
      const Matrix6 shared =
          before * inverse.inverse(earlier, later) * after.transpose();
      covariance += before * inverse.inverse(earlier, earlier) * before.transpose() +
                    shared + shared.transpose();
    }
    const Vector6 r = motionResidual(link.motion, motion);
    if (r.dot(covariance.ldlt().solve(r)) < max_squared)
      plausible.push_back(link);
  }
  links_ = std::move(plausible);
}

bool
RevisitLinks::dropContradicted(const Poses& poses)
{
  std::vector<std::pair<double, std::size_t>> contradicted;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    const Vector6 r =
        motionResidual(link.motion, poses[link.earlier].inverse() * poses[link.later]);
    const double squared = r.dot(link.information * r);
    if (!(squared < max_squared))
      contradicted.emplace_back(-squared, i);
  }
  if (contradicted.empty())
    return false;
  std::sort(contradicted.begin(), contradicted.end());
  contradicted.resize((contradicted.size() + 9) / 10);
  std::vector<char> is_dropped(links_.size());
  for (const auto& [squared, i] : contradicted)
    is_dropped[i] = 1;
  std::vector<Link> kept;
  for (std::size_t i = 0; i < links_.size(); ++i)
    if (!is_dropped[i])
      kept.push_back(links_[i]);
  links_ = std::move(kept);
  return true;
}

} // namespace pcl::acmap
