#include "chain/appearance_term.h"
#include "chain/feature_pairs.h"
#include "chain/motion_step.h"
#include "chain/surface_term.h"
#include "chain_views.h"

#include <Eigen/LU>

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace pcl::acmap::test {

namespace {

const Eigen::Isometry3d T_target_source =
    poseOf({0.03, -0.02, 0.05}, 0.02, -0.015, 0.01);

/** \brief Derivatives of a sum of costs with respect to the six parameters of a small
 * motion. */
Vector6
numericalGradient(const std::function<double(const Eigen::Isometry3d&)>& cost)
{
  constexpr double h = 1e-5;
  Vector6 gradient;
  for (int i = 0; i < 6; ++i) {
    const Vector6 step = h * Vector6::Unit(i);
    gradient[i] = (cost(afterStep(step, T_target_source)) -
                   cost(afterStep(-step, T_target_source))) /
                  (2 * h);
  }
  return gradient;
}

Pinhole
pinholeOf(const CameraView& view)
{
  return fitUprightPinhole(
             {view.points.data(), sizeof view.points[0], view.points.size()},
             static_cast<std::size_t>(view.image.width))
      .value();
}

void
expectNear(const Vector6& found, const Vector6& wanted, double share)
{
  EXPECT_LT((found - wanted).norm(), share * wanted.norm()) << found.transpose() << "\n"
                                                            << wanted.transpose();
}

std::vector<FeaturePair>
featurePairs()
{
  Random random(3);
  std::vector<FeaturePair> pairs;
  for (int i = 0; i < 12; ++i) {
    const Eigen::Vector3d source(
        random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(2, 4));
    const auto covariance = [&] {
      const Eigen::Matrix3d root =
          Eigen::Matrix3d::NullaryExpr([&] { return 0.01 * random.normal(); });
      return Eigen::Matrix3d(root * root.transpose() +
                             1e-5 * Eigen::Matrix3d::Identity());
    };
    pairs.push_back(
        {0,
         0,
         source,
         T_target_source * source +
             0.01 * Eigen::Vector3d(random.normal(), random.normal(), random.normal()),
         covariance(),
         covariance()});
  }
  return pairs;
}

/** \brief Positive definite, with different scales of the unknowns as in a real
 * problem. */
NormalEquations
randomEquations(std::uint64_t seed)
{
  Random random(seed);
  NormalEquations equations;
  for (int i = 0; i < 20; ++i)
    equations.add(motionRow({random.normal(), random.normal(), 3 + random.normal()},
                            {random.normal(), random.normal(), random.normal()}),
                  random.normal(),
                  random.uniform(1, 1e4));
  return equations;
}

} // namespace

// The equations use constant weights: Cauchy's cost has the same gradient.
TEST(ChainOracle, featureGradientIsTheCostsDerivative)
{
  const std::vector<FeaturePair> pairs = featurePairs();
  const auto cost = [&](const Eigen::Isometry3d& motion) {
    double sum = 0;
    for (const FeaturePair& pair : pairs) {
      // covariances rotate with the motion, which the equations ignore
      const Eigen::Matrix3d covariance =
          pair.target_covariance + T_target_source.linear() * pair.source_covariance *
                                       T_target_source.linear().transpose();
      const Eigen::Vector3d difference = motion * pair.source - pair.target;
      sum += 4.5 * std::log1p(difference.dot(covariance.inverse() * difference) / 9);
    }
    return sum;
  };
  expectNear(featureTerm(pairs, T_target_source).equations.gradient,
             numericalGradient(cost),
             1e-6);
}

TEST(ChainOracle, squaredDistanceIsMahalanobis)
{
  for (const FeaturePair& pair : featurePairs()) {
    const Eigen::Matrix3d covariance =
        pair.target_covariance + T_target_source.linear() * pair.source_covariance *
                                     T_target_source.linear().transpose();
    const Eigen::Vector3d difference = T_target_source * pair.source - pair.target;
    EXPECT_NEAR(squaredDistance(pair, T_target_source),
                difference.dot(covariance.inverse() * difference),
                1e-9);
  }
}

TEST(ChainOracle, surfaceGradientIsTheCostsDerivative)
{
  const CameraView now = chainView(Room(), poseOf({0, 0, 0}, 0));
  const CameraView before = chainView(Room(), poseOf({0, 0, 0}, 0) * T_target_source);
  const SurfaceBlocks source = surfaceBlocks(now), target = surfaceBlocks(before);
  const Pinhole pinhole = pinholeOf(before);
  const SurfaceTerm term = surfaceTerm(source, target, pinhole, T_target_source, 0.3);
  ASSERT_GT(term.evidence.count, 300u);
  const auto cost = [&](const Eigen::Isometry3d& motion) {
    return surfaceTerm(source, target, pinhole, motion, 0.3).evidence.cost;
  };
  expectNear(term.evidence.equations.gradient, numericalGradient(cost), 0.03);
}

// The view's gradients are central differences, those of the samples are bilinear. Only
// the centre of one wall is compared, so that the same pixels count for every motion.
TEST(ChainOracle, appearanceGradientIsNearTheCostsDerivative)
{
  Room room;
  room.walls.max().z() = 2.5;
  room.things.clear();
  const Eigen::Isometry3d pose = poseOf({0, 0, 0}, 0);
  const CameraView before = chainView(room, pose);
  CameraView now = chainView(room, pose * T_target_source);
  for (std::size_t i = 0; i < now.points.size(); ++i)
    if (i % 320 < 80 || i % 320 > 240 || i / 320 < 60 || i / 320 > 180)
      now.points[i].setConstant(std::numeric_limits<float>::quiet_NaN());
  const AppearanceLevel source = appearanceLevel(viewLevels(now).at(1));
  const AppearanceLevel target = appearanceLevel(viewLevels(before).at(1));
  const Pinhole pinhole = pinholeOf(before);
  const LightChange light{1.1, -7};
  const Evidence evidence =
      appearanceTerm(source, target, pinhole, T_target_source, light);
  ASSERT_GT(evidence.count, 3000u);
  const auto cost = [&](const Eigen::Isometry3d& motion) {
    const Evidence moved = appearanceTerm(source, target, pinhole, motion, light);
    EXPECT_EQ(moved.count, evidence.count);
    return moved.cost;
  };
  expectNear(evidence.equations.gradient, numericalGradient(cost), 0.2);
}

TEST(ChainOracle, lightIsMeasured)
{
  const Eigen::Isometry3d pose = poseOf({0, 0, 0}, 0);
  RoomCamera dim;
  dim.gain = 0.6;
  dim.offset = 30;
  const CameraView before = chainView(Room(), pose);
  const LightChange light =
      lightChange(appearanceLevel(viewLevels(chainView(Room(), pose, dim)).at(1)),
                  appearanceLevel(viewLevels(before).at(1)),
                  pinholeOf(before),
                  Eigen::Isometry3d::Identity());
  EXPECT_NEAR(light.gain, 0.6, 0.005);
  EXPECT_NEAR(light.offset, 30, 0.5);
}

TEST(ChainOracle, covarianceIsTheInverseInsideOfTheModel)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const NormalEquations equations = randomEquations(seed);
    const Matrix6 whole = equations.matrix.selfadjointView<Eigen::Upper>();
    EXPECT_TRUE(
        covarianceOf(equations, MotionModel::Rigid).isApprox(whole.inverse(), 1e-8));
    const Eigen::Matrix<double, 6, Eigen::Dynamic> basis =
        motionBasis(MotionModel::Planar);
    const Matrix6 planar =
        basis * (basis.transpose() * whole * basis).inverse() * basis.transpose();
    EXPECT_TRUE(covarianceOf(equations, MotionModel::Planar).isApprox(planar, 1e-8));
    const Vector6 step = solvedStep(equations, MotionModel::Rigid);
    EXPECT_TRUE((whole * step).isApprox(-equations.gradient, 1e-8));
  }
}

TEST(ChainOracle, whatIsOpenIsInfiniteAndStays)
{
  NormalEquations wall; // one frontal plane determines z and the rotations about x and
                        // y
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {-1.0, 0.0, 1.0})
      wall.add(motionRow({x, y, 2}, {0, 0, 1}), 0.1, 100);
  const Vector6 step = solvedStep(wall, MotionModel::Rigid);
  EXPECT_TRUE(step.isApprox(-0.1 * Vector6::Unit(2), 1e-9)) << step.transpose();
  EXPECT_EQ(covarianceOf(wall, MotionModel::Rigid)(0, 0),
            std::numeric_limits<double>::infinity());
  const Matrix6 planar = covarianceOf(wall, MotionModel::Planar);
  EXPECT_EQ(planar(0, 0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(planar(1, 1), 0);
}

TEST(ChainOracle, stepsAreRigid)
{
  Eigen::Isometry3d pose = T_target_source;
  Vector6 step;
  step << 0.01, -0.02, 0.03, 0.1, -0.2, 0.05;
  for (int i = 0; i < 1000; ++i)
    pose = afterStep(step, pose);
  EXPECT_LT(
      (pose.linear() * pose.linear().transpose() - Eigen::Matrix3d::Identity()).norm(),
      1e-12);
  EXPECT_LT(motionBetween(T_target_source, afterStep(step, T_target_source))
                    .tail<3>()
                    .norm() -
                step.tail<3>().norm(),
            1e-9);
}

} // namespace pcl::acmap::test
