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
    links_.push_back({{revisit.earlier, revisit.later, revisit.T_earlier_later},
                      covariance,
                      covariance.llt().solve(Matrix6::Identity())});
  }
}

void
RevisitLinks::addPairs(std::vector<PoseSystem::Pair>& pairs) const
{
  for (const Link& link : links_)
    if (link.motion.earlier > 0)
      pairs.emplace_back(link.motion.earlier - 1, link.motion.later - 1);
}

double
RevisitLinks::cost(const Poses& poses) const
{
  double cost = 0;
  for (const Link& link : links_)
    cost += link.motion.cost(poses, link.information);
  return cost;
}

void
RevisitLinks::linearize(const Poses& poses,
                        PoseSystem& system,
                        std::vector<Vector6>& gradient) const
{
  for (const Link& link : links_)
    link.motion.linearize(poses, link.information, system, gradient);
}

void
RevisitLinks::dropImplausible(const Poses& poses, const PoseSystem& inverse)
{
  const auto isImplausible = [&](const Link& link) {
    const Matrix6 covariance = link.covariance + link.motion.covariance(poses, inverse);
    const Vector6 r = link.motion.residual(poses);
    return !(r.dot(covariance.ldlt().solve(r)) < max_squared);
  };
  links_.erase(std::remove_if(links_.begin(), links_.end(), isImplausible),
               links_.end());
}

bool
RevisitLinks::dropContradicted(const Poses& poses)
{
  std::vector<std::pair<double, std::size_t>> contradicted;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const double squared = links_[i].motion.cost(poses, links_[i].information);
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
