#include "room_views.h"

#include <pcl/egomotion/visual_egomotion.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {

namespace {

using Egomotion = VisualEgomotion<PointXYZRGBSigma>;
using Cloud = PointCloud<PointXYZRGBSigma>;

/** \brief Poses of both cameras, and the motion model. */
struct Motion {
  MotionModel model;
  Eigen::Isometry3d before, now;

  Eigen::Isometry3d
  truth() const
  {
    return before.inverse() * now;
  }
};

Motion
planar(double dx, double dz, double dtheta)
{
  return {MotionModel::Planar,
          poseOf({-0.3, 0, -0.5}, 0.1),
          poseOf({-0.3, 0, -0.5}, 0.1) * poseOf({dx, 0, dz}, dtheta)};
}

Motion
rigid(const Eigen::Vector3d& moved, double turn, double tilt, double roll)
{
  const Eigen::Isometry3d before = poseOf({-0.3, -0.1, -0.5}, 0.1, -0.1, 0.2);
  return {MotionModel::Rigid, before, before * poseOf(moved, turn, tilt, roll)};
}

std::vector<Motion>
motions()
{
  return {planar(0, 0, 0),
          planar(0, 0.2, 0),
          planar(0.15, -0.1, 0.05),
          planar(0, 0, -0.2),
          planar(-0.05, 0.3, 0.1),
          rigid({0, 0, 0.1}, 0, 0, 0),
          rigid({0.08, -0.06, 0.1}, 0.06, -0.05, 0.04),
          rigid({0, 0, 0}, -0.1, 0.1, 0),
          rigid({-0.1, 0.05, -0.1}, 0.03, 0.02, -0.1)};
}

Egomotion
egomotionOf(MotionModel model,
            const Cloud::ConstPtr& now,
            const Cloud::ConstPtr& before)
{
  Egomotion egomotion;
  egomotion.setMotionModel(model);
  egomotion.setInputSource(now);
  egomotion.setInputTarget(before);
  return egomotion;
}

/** \brief Squared Mahalanobis distance of a motion in the free coordinates. */
double
squaredDeviations(const Eigen::Matrix<double, 6, 1>& motion,
                  const Eigen::Matrix<double, 6, 6>& covariance)
{
  return motion.dot(covariance.completeOrthogonalDecomposition().pseudoInverse() *
                    motion);
}

void
expectRecovered(const Motion& motion, const Room& room, bool refines)
{
  Egomotion egomotion =
      egomotionOf(motion.model, viewOf(room, motion.now), viewOf(room, motion.before));
  egomotion.setRefinement(refines);
  const auto estimate = egomotion.compute();
  ASSERT_TRUE(estimate) << egomotion.getReport().reason;
  const Eigen::Matrix<double, 6, 1> error =
      motionBetween(motion.truth(), estimate->T_target_source);
  EXPECT_LT(error.head<3>().norm(), refines ? 0.0015 : 0.006);
  EXPECT_LT(error.tail<3>().norm(), refines ? 0.0006 : 0.002);
}

} // namespace

TEST(VisualEgomotion, featuresFindTheMotion)
{
  for (const Motion& motion : motions())
    expectRecovered(motion, Room(), false);
}

TEST(VisualEgomotion, surfacesAndBrightnessFindItToAMillimetre)
{
  for (const Motion& motion : motions())
    expectRecovered(motion, Room(), true);
}

TEST(VisualEgomotion, actionIsTheMotionOnTheFloor)
{
  const Motion motion = planar(0.15, -0.1, 0.05);
  Egomotion egomotion = egomotionOf(
      motion.model, viewOf(Room(), motion.now), viewOf(Room(), motion.before));
  const auto estimate = egomotion.compute();
  ASSERT_TRUE(estimate);
  EXPECT_NEAR(estimate->action.dx, 0.15, 0.002);
  EXPECT_NEAR(estimate->action.dz, -0.1, 0.002);
  EXPECT_NEAR(estimate->action.dtheta, 0.05, 0.001);
  const PlanarPose pose{
      estimate->action.dx, estimate->action.dz, estimate->action.dtheta};
  EXPECT_TRUE(isometryOf(pose).isApprox(estimate->T_target_source, 1e-9));
  EXPECT_TRUE(estimate->covariance.row(1).isZero());
  EXPECT_TRUE(estimate->covariance.row(3).isZero());
  EXPECT_TRUE(estimate->covariance.row(5).isZero());
}

TEST(VisualEgomotion, swappedViewsGiveTheWayBack)
{
  for (const Motion& motion : motions()) {
    const auto now = viewOf(Room(), motion.now), before = viewOf(Room(), motion.before);
    const auto there = egomotionOf(motion.model, now, before).compute();
    const auto back = egomotionOf(motion.model, before, now).compute();
    ASSERT_TRUE(there && back);
    const Eigen::Matrix<double, 6, 1> gap =
        motionBetween(there->T_target_source, back->T_target_source.inverse());
    EXPECT_LT(squaredDeviations(gap, there->covariance), 9);
  }
}

TEST(VisualEgomotion, lightChangesNothing)
{
  for (const Motion& motion : motions()) {
    const auto before = viewOf(Room(), motion.before);
    const auto plain =
        egomotionOf(motion.model, viewOf(Room(), motion.now), before).compute();
    RoomCamera dim;
    dim.gain = 0.7;
    dim.offset = 25;
    const auto dimmed =
        egomotionOf(motion.model, viewOf(Room(), motion.now, dim), before).compute();
    ASSERT_TRUE(plain && dimmed);
    const Eigen::Matrix<double, 6, 1> gap =
        motionBetween(plain->T_target_source, dimmed->T_target_source);
    EXPECT_LT(squaredDeviations(gap, plain->covariance), 1);
  }
}

TEST(VisualEgomotion, closedFormGivesTheSameMotion)
{
  for (const Motion& motion : motions()) {
    const auto now = viewOf(Room(), motion.now), before = viewOf(Room(), motion.before);
    for (const bool refines : {false, true}) {
      Egomotion egomotion = egomotionOf(motion.model, now, before);
      egomotion.setRefinement(refines);
      const auto descended = egomotion.compute();
      egomotion.setSolver(MotionSolver::ClosedForm);
      const auto solved = egomotion.compute();
      ASSERT_TRUE(descended && solved);
      const Eigen::Matrix<double, 6, 1> gap =
          motionBetween(descended->T_target_source, solved->T_target_source);
      EXPECT_LT(squaredDeviations(gap, descended->covariance), 0.0001);
    }
  }
}

} // namespace pcl::acmap::test
