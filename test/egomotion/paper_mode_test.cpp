#include "naive_egomotion.h"
#include "room_views.h"

#include <pcl/core/exceptions.h>
#include <pcl/egomotion/visual_egomotion.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace pcl::acmap::test {

namespace {

using Egomotion = VisualEgomotion<PointXYZRGBSigma>;
using Cloud = PointCloud<PointXYZRGBSigma>;

class PaperMode : public testing::Test {
protected:
  PaperMode()
  {
    egomotion_.setPaperMode(true);
    egomotion_.setInputSource(noisyView(now, 1));
    egomotion_.setInputTarget(noisyView(before, 2));
  }

  static Cloud::Ptr
  noisyView(const Eigen::Isometry3d& pose, std::uint64_t seed)
  {
    RoomCamera noisy;
    noisy.width = 160;
    noisy.height = 120;
    noisy.focal_length = 130;
    noisy.noise = 1;
    noisy.seed = seed;
    return viewOf(Room(), pose, noisy);
  }

  /** Brightness by position in the image, points on a frontal wall at 2 m. */
  static Cloud::Ptr
  paintedWall(const std::function<double(int, int)>& brightness)
  {
    const Cloud::Ptr wall(new Cloud(120, 90));
    for (int i = 0; i < 120 * 90; ++i) {
      PointXYZRGBSigma& point = (*wall)[i];
      point.getVector3fMap() << (i % 120) * 0.01F, (i / 120) * 0.01F, 2;
      point.r = point.g = point.b =
          static_cast<std::uint8_t>(brightness(i % 120, i / 120));
    }
    return wall;
  }

  Eigen::Matrix4d
  run()
  {
    const auto estimate = egomotion_.compute();
    EXPECT_TRUE(estimate) << egomotion_.getReport().reason;
    return estimate ? estimate->T_target_source.matrix() : Eigen::Matrix4d::Zero();
  }

  EgomotionOutcome
  outcomeOf(const Cloud::ConstPtr& source, const Cloud::ConstPtr& target)
  {
    egomotion_.setInputSource(source);
    egomotion_.setInputTarget(target);
    egomotion_.compute();
    return egomotion_.getReport().outcome;
  }

  Egomotion egomotion_;
};

TEST_F(PaperMode, isOffUnlessItIsSet)
{
  Egomotion plain;
  EXPECT_FALSE(plain.getPaperMode());
  EXPECT_EQ(plain.getMaximumRingShifts(), 0);
  EXPECT_EQ(plain.getMaximumSectorShifts(), 0);
  EXPECT_EQ(egomotion_.getMaximumRingShifts(), 1);
  EXPECT_EQ(egomotion_.getMaximumSectorShifts(), 1);
  egomotion_.setMaximumShifts(2, 3);
  EXPECT_EQ(egomotion_.getMaximumRingShifts(), 2);
  egomotion_.setPaperMode(false);
  EXPECT_EQ(egomotion_.getMaximumSectorShifts(), 3);
  EXPECT_THROW(egomotion_.setMaximumShifts(11, 0), BadArgumentException);
  EXPECT_THROW(egomotion_.setMaximumShifts(0, 13), BadArgumentException);
  EXPECT_THROW(egomotion_.setMaximumShifts(-1, 0), BadArgumentException);
}

TEST_F(PaperMode, isOneFitOfAllThatRemain)
{
  run();
  const EgomotionReport& report = egomotion_.getReport();
  EXPECT_TRUE(report.is_paper);
  EXPECT_EQ(report.fits, 1u);
  EXPECT_GT(report.iterations, 0u);
  EXPECT_EQ(report.matches, report.consistent + report.removed);
  EXPECT_EQ(report.inliers, report.consistent);
  EXPECT_GT(report.feature_residual, 0);
  EXPECT_FALSE(report.is_refined);
  EXPECT_EQ(report.surface_pairs, 0u);
  EXPECT_EQ(report.feature_chi, 0);

  egomotion_.setPaperMode(false);
  run();
  EXPECT_FALSE(egomotion_.getReport().is_paper);
  EXPECT_GT(egomotion_.getReport().fits, 1u);
}

TEST_F(PaperMode, overridesWhatContradictsIt)
{
  const Eigen::Matrix4d wanted = run();
  egomotion_.setRefinement(true);
  EXPECT_EQ(run(), wanted);
  egomotion_.setRefinement(false);
  EXPECT_EQ(run(), wanted);
  egomotion_.setMaximumKeypoints(10);
  egomotion_.setMaximumTranslation(0.01);
  egomotion_.setMaximumRotation(0);
  egomotion_.setSolver(MotionSolver::ClosedForm);
  EXPECT_EQ(run(), wanted);
  EXPECT_GT(egomotion_.getReport().iterations, 0u);
}

TEST_F(PaperMode, sigmasHaveNoWeight)
{
  const Eigen::Matrix4d wanted = run();
  const Cloud::Ptr other(new Cloud(*egomotion_.getInputSource()));
  for (std::size_t i = 0; i < other->size(); ++i)
    (*other)[i].sigma = i % 2 ? 1e-4F : 1.0F;
  egomotion_.setInputSource(other);
  EXPECT_EQ(run(), wanted);
}

TEST_F(PaperMode, isNotOursAndIsForgottenWhenItIsOff)
{
  const Eigen::Matrix4d paper = run();
  Egomotion fresh;
  fresh.setInputSource(egomotion_.getInputSource());
  fresh.setInputTarget(egomotion_.getInputTarget());
  const auto ours = fresh.compute();
  ASSERT_TRUE(ours);
  EXPECT_NE(ours->T_target_source.matrix(), paper);
  egomotion_.setPaperMode(false);
  EXPECT_EQ(run(), ours->T_target_source.matrix());
  egomotion_.setPaperMode(true);
  EXPECT_EQ(run(), paper);
}

TEST_F(PaperMode, isTheSameForEveryNumberOfThreads)
{
  const Eigen::Matrix4d wanted = run();
  for (const unsigned threads : {1U, 2U, 8U}) {
    Egomotion egomotion;
    egomotion.setPaperMode(true);
    egomotion.setNumberOfThreads(threads);
    egomotion.setInputSource(egomotion_.getInputSource());
    egomotion.setInputTarget(egomotion_.getInputTarget());
    const auto estimate = egomotion.compute();
    ASSERT_TRUE(estimate);
    EXPECT_EQ(estimate->T_target_source.matrix(), wanted);
  }
}

TEST_F(PaperMode, rigidMotionsAreFittedToo)
{
  const Eigen::Isometry3d tilted = before * poseOf({0.05, 0.1, 0.1}, 0.03, 0.1, 0.05);
  egomotion_.setInputSource(noisyView(tilted, 3));
  egomotion_.setMotionModel(MotionModel::Rigid);
  const auto estimate = egomotion_.compute();
  ASSERT_TRUE(estimate) << egomotion_.getReport().reason;
  EXPECT_EQ(egomotion_.getReport().fits, 1u);
  const Eigen::Matrix<double, 6, 1> error =
      motionBetween(before.inverse() * tilted, estimate->T_target_source);
  EXPECT_LT(error.head<3>().norm(), 0.03);
  EXPECT_LT(error.tail<3>().norm(), 0.01);
}

TEST_F(PaperMode, failsOnlyIfTheMatchesDoNotTellTheMotion)
{
  const Cloud::Ptr blank = paintedWall([](int, int) { return 100; });
  EXPECT_EQ(outcomeOf(blank, blank), EgomotionOutcome::BlankView);

  const auto blob = [](int x, int y, int at_x, int at_y) {
    return 120 * std::exp(-(2 * std::pow(x - at_x, 2) + std::pow(y - at_y, 2)) / 18.0);
  };
  const Cloud::Ptr wall =
      paintedWall([&](int x, int y) { return 50 + blob(x, y, 60, 45); });
  const EgomotionOutcome outcome = outcomeOf(wall, wall);
  EXPECT_EQ(outcome, EgomotionOutcome::Estimated) << egomotion_.getReport().reason;
  EXPECT_LT(egomotion_.getReport().inliers, 6u);

  const Cloud::Ptr one_place(new Cloud(*egomotion_.getInputTarget()));
  for (PointXYZRGBSigma& point : *one_place)
    point.getVector3fMap() << 0, 0, 2;
  EXPECT_EQ(outcomeOf(one_place, one_place), EgomotionOutcome::Unobservable);
}

} // namespace
} // namespace pcl::acmap::test
