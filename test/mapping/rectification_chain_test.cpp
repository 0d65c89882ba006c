#include "rectification_worlds.h"

#include "rectification/action_chain.h"

#include <pcl/core/random.h>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

std::vector<PlanarPose>
windingPath(std::size_t poses, std::uint64_t seed)
{
  Random random(seed);
  std::vector<PlanarPose> path{{3, -2, 0.7}};
  for (std::size_t t = 1; t < poses; ++t)
    path.push_back(moved(path.back(), {random.normal(), 1, 0.3 * random.normal()}));
  return path;
}

Eigen::VectorXd
randomResiduals(const ActionChain& chain, std::uint64_t seed)
{
  Random random(seed);
  Eigen::VectorXd u(chain.variables());
  for (double& part : u)
    part = 2 * random.normal();
  return u;
}

void
expectSame(const PlanarPose& found, const PlanarPose& wanted, double slack)
{
  EXPECT_NEAR(found.x, wanted.x, slack);
  EXPECT_NEAR(found.z, wanted.z, slack);
  EXPECT_NEAR(std::remainder(found.theta - wanted.theta, 2 * M_PI), 0, slack);
}

/** A function that depends differently on each pose. */
double
valueOf(const std::vector<PlanarPose>& poses)
{
  double sum = 0;
  for (std::size_t t = 0; t < poses.size(); ++t) {
    const double k = 1 + 0.1 * static_cast<double>(t);
    sum += std::sin(k * poses[t].x) + poses[t].z * poses[t].z * k +
           std::cos(poses[t].theta + k) * poses[t].x;
  }
  return sum;
}

std::vector<Eigen::Vector3d>
derivativesOf(const std::vector<PlanarPose>& poses)
{
  std::vector<Eigen::Vector3d> by_pose;
  for (std::size_t t = 0; t < poses.size(); ++t) {
    const double k = 1 + 0.1 * static_cast<double>(t);
    by_pose.emplace_back(k * std::cos(k * poses[t].x) + std::cos(poses[t].theta + k),
                         2 * k * poses[t].z,
                         -std::sin(poses[t].theta + k) * poses[t].x);
  }
  return by_pose;
}

TEST(ActionChain, withoutResidualsIsOdometry)
{
  const std::vector<PlanarPose> path = windingPath(30, 1);
  const ActionChain chain(path, {});
  EXPECT_EQ(chain.residuals(), 87);
  EXPECT_EQ(chain.variables(), 88);
  const auto poses = chain.poses(Eigen::VectorXd::Zero(88));
  ASSERT_EQ(poses.size(), path.size());
  for (std::size_t t = 0; t < path.size(); ++t)
    expectSame(poses[t], path[t], 1e-12);
}

TEST(ActionChain, residualsAreInSigmasOfTheirAction)
{
  const OdometryNoise noise{0.01, 0.1, 0.02, 0.5};
  const std::vector<PlanarPose> path{{0, 0, 0}, {0, 5, 0.4}};
  const ActionChain chain(path, noise);
  const auto sideways = chain.poses(Eigen::Vector4d(1, 0, 0, 0));
  EXPECT_NEAR(sideways[1].x, 0.01 + 5 * 0.1, 1e-12);
  const auto ahead = chain.poses(Eigen::Vector4d(0, -2, 0, 0));
  EXPECT_NEAR(ahead[1].z, 5 - 2 * (0.01 + 5 * 0.1), 1e-12);
  const auto turned = chain.poses(Eigen::Vector4d(0, 0, 3, 0));
  EXPECT_NEAR(turned[1].theta, 0.4 + 3 * (0.02 + 0.4 * 0.5), 1e-12);
}

TEST(ActionChain, theWholeMapTurnsAboutTheFirstPoseAndThePathDoesNot)
{
  const ActionChain chain(windingPath(9, 7), {});
  Eigen::VectorXd u = randomResiduals(chain, 7);
  u[chain.residuals()] = 0;
  const std::vector<PlanarPose> path = chain.poses(u);
  u[chain.residuals()] = 5;
  const std::vector<PlanarPose> turned = chain.poses(u);
  EXPECT_EQ(turned[0].x, path[0].x);
  EXPECT_GT(std::abs(turned[0].theta - path[0].theta), 0.01);
  const std::vector<PlanarPose> back = chain.path(u);
  for (std::size_t t = 1; t < path.size(); ++t) {
    const PlanarAction wanted = actionBetween(path[0], path[t]);
    const PlanarAction found = actionBetween(turned[0], turned[t]);
    expectSame({found.dx, found.dz, found.dtheta},
               {wanted.dx, wanted.dz, wanted.dtheta},
               1e-12);
    expectSame(back[t], path[t], 1e-12);
  }
}

TEST(ActionChain, gradientIsThatOfDifferences)
{
  for (const std::uint64_t seed : {2, 3, 4}) {
    const ActionChain chain(windingPath(12, seed), {0.05, 0.1, 0.05, 0.2});
    const Eigen::VectorXd u = randomResiduals(chain, seed);
    const std::vector<PlanarPose> poses = chain.poses(u);
    const Eigen::VectorXd found = chain.gradient(poses, derivativesOf(poses));
    ASSERT_EQ(found.size(), u.size());
    for (Eigen::Index i = 0; i < u.size(); ++i) {
      constexpr double h = 1e-5;
      Eigen::VectorXd more = u, less = u;
      more[i] += h;
      less[i] -= h;
      const double wanted =
          (valueOf(chain.poses(more)) - valueOf(chain.poses(less))) / (2 * h);
      EXPECT_NEAR(found[i], wanted, 1e-6 * (1 + std::abs(wanted))) << i;
    }
  }
}

TEST(ActionChain, thePriorIsThatOfTurnsWithAnErrorInCommon)
{
  const ActionChain independent(windingPath(9, 3), {});
  const ActionChain chain = independent.withCommonTurn();
  const Eigen::VectorXd u = randomResiduals(chain, 6);
  const Eigen::Index residuals = chain.residuals();
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Identity(residuals, residuals);
  for (Eigen::Index i = 2; i < residuals; i += 3)
    for (Eigen::Index k = 2; k < residuals; k += 3)
      covariance(i, k) += 0.25;
  const Eigen::VectorXd whitened = covariance.llt().solve(u.head(residuals));
  Eigen::VectorXd gradient;
  EXPECT_NEAR(chain.prior(u, &gradient), u.head(residuals).dot(whitened) / 2, 1e-9);
  EXPECT_NEAR(chain.prior(u), chain.prior(u, &gradient), 0);
  ASSERT_EQ(gradient.size(), u.size());
  EXPECT_LT((gradient.head(residuals) - whitened).norm(), 1e-9);
  EXPECT_EQ(gradient[residuals], 0) << "the whole map turns freely";
  EXPECT_NEAR(independent.prior(u), u.head(residuals).squaredNorm() / 2, 1e-9);
}

TEST(ActionChain, aPartIsTheSamePathFromTheOrigin)
{
  const ActionChain chain(windingPath(20, 5), {});
  const Eigen::VectorXd u = randomResiduals(chain, 5);
  const std::vector<PlanarPose> whole = chain.poses(u);
  for (const auto& [first, last] :
       {std::pair<std::size_t, std::size_t>{0, 20}, {4, 12}, {19, 20}}) {
    const ActionChain part = chain.part(first, last);
    EXPECT_EQ(part.residuals(), 3 * static_cast<Eigen::Index>(last - first - 1));
    Eigen::VectorXd v = Eigen::VectorXd::Zero(part.variables());
    v.head(part.residuals()) =
        u.segment(3 * static_cast<Eigen::Index>(first), part.residuals());
    const auto poses = part.poses(v);
    ASSERT_EQ(poses.size(), last - first);
    for (std::size_t t = 0; t < poses.size(); ++t) {
      const PlanarAction wanted = actionBetween(whole[first], whole[first + t]);
      expectSame(poses[t], {wanted.dx, wanted.dz, wanted.dtheta}, 1e-12);
    }
  }
}

TEST(ActionChain, widenedResidualsGoFarther)
{
  const ActionChain chain(windingPath(20, 6), {});
  const Eigen::VectorXd u = randomResiduals(chain, 6);
  Eigen::VectorXd fourfold = 4 * u;
  fourfold[chain.residuals()] = u[chain.residuals()];
  const auto wanted = chain.poses(fourfold), found = chain.widened(4).poses(u);
  for (std::size_t t = 0; t < found.size(); ++t)
    expectSame(found[t], wanted[t], 1e-9);
}

} // namespace
} // namespace pcl::acmap::test
