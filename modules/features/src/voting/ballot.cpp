#include "voting/ballot.h"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <limits>

namespace pcl::acmap::voting {
namespace {

VertexClass
classify(const Eigen::Vector3d& ascending, const VotingSettings& settings)
{
  const double surface = ascending[2] - ascending[1];
  const double crease = settings.creaseWeight() * (ascending[1] - ascending[0]);
  const double corner =
      settings.creaseWeight() * settings.cornerWeight() * ascending[0];
  if (surface >= crease && surface >= corner)
    return VertexClass::Surface;
  return crease >= corner ? VertexClass::Crease : VertexClass::Corner;
}

} // namespace

VotedNormal
noNormal()
{
  VotedNormal none;
  none.normal.setConstant(std::numeric_limits<float>::quiet_NaN());
  none.direction = none.normal;
  none.saliency = none.normal.x();
  return none;
}

// Computed in double precision, because the closed-form solution loses half of the
// digits for equal eigenvalues, and a plane has two equal ones.
VotedNormal
Ballot::count(const Eigen::Vector3f& front, const VotingSettings& settings) const
{
  Eigen::Matrix3d sum;
  sum << xx_, xy_, xz_, // symmetric
      xy_, yy_, yz_,    //
      xz_, yz_, zz_;
  const double trace = sum.trace();
  if (!(trace > 0 && std::isfinite(trace)))
    return noNormal();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(sum / trace);
  const Eigen::Vector3d ascending = solver.eigenvalues().cwiseMax(0.0);
  VotedNormal result;
  result.normal = solver.eigenvectors().col(2).cast<float>();
  if (result.normal.dot(front) < 0)
    result.normal = -result.normal;
  result.direction = solver.eigenvectors().col(0).cast<float>();
  result.saliency = static_cast<float>(ascending[2] - ascending[1]);
  result.votes = static_cast<std::uint32_t>(votes_);
  result.vertex_class = classify(ascending, settings);
  return result;
}

} // namespace pcl::acmap::voting
