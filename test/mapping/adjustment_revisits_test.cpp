#include "adjustment_room.h"

#include <pcl/core/trajectory_error.h>
#include <pcl/mapping/plane_adjustment.h>

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace pcl::acmap::test {
namespace {

using RevisitPoses = std::vector<Eigen::Isometry3d>;

constexpr double view_sigma = 0.005, action_length = 0.01; // metres
constexpr std::size_t path_views = 16;

/** The room with so much drift that the ends of the path do not meet. */
class AdjustedRevisits : public testing::Test {
protected:
  static void
  SetUpTestSuite()
  {
    for (std::size_t i = 0; i < truth_.size(); ++i)
      clouds_.push_back(AdjustmentRoom::view(truth_[i], view_sigma, i + 1));
  }

  static void
  TearDownTestSuite()
  {
    clouds_.clear();
  }

  void
  add(const RevisitPoses& given, double turn)
  {
    adjustment_.clear();
    for (std::size_t i = 0; i < given.size(); ++i)
      adjustment_.addPointCloud(clouds_[i], given[i]);
    adjustment_.setOdometryNoise({action_length, 0, turn, 0});
  }

  /** The true motion, moved. */
  void
  addRevisit(std::size_t earlier,
             std::size_t later,
             const Eigen::Vector3d& error = Eigen::Vector3d::Zero())
  {
    Eigen::Isometry3d motion = truth_[earlier].inverse() * truth_[later];
    motion.translation() += error;
    adjustment_.addRevisit(
        earlier, later, motion, 1e-6 * Eigen::Matrix<double, 6, 6>::Identity());
  }

  double
  errorAfter()
  {
    adjustment_.compute();
    return absoluteTrajectoryError(poses(), truth_).unaligned;
  }

  RevisitPoses
  poses() const
  {
    RevisitPoses result;
    for (std::size_t i = 0; i < adjustment_.getNumberOfPointClouds(); ++i)
      result.push_back(adjustment_.getPose(i));
    return result;
  }

  static inline const RevisitPoses truth_ = AdjustmentRoom::path(path_views);
  static inline std::vector<PointCloud<PointXYZRGBSigma>::ConstPtr> clouds_;
  PlaneAdjustment<PointXYZRGBSigma> adjustment_;
};

TEST_F(AdjustedRevisits, rightOnesAreUsed)
{
  const double turn = 0.006;
  add(AdjustmentRoom::drifted(truth_, turn, action_length, 3), turn);
  addRevisit(0, path_views - 1);
  addRevisit(1, path_views - 2);
  EXPECT_LT(errorAfter(), 0.003);
  EXPECT_EQ(adjustment_.getReport().revisits_used, 2U);
  EXPECT_EQ(adjustment_.getReport().revisits_dropped, 0U);
}

TEST_F(AdjustedRevisits, wrongOnesAreDroppedAndChangeNothing)
{
  const double turn = 0.006;
  const RevisitPoses given = AdjustmentRoom::drifted(truth_, turn, action_length, 3);
  add(given, turn);
  const double without = errorAfter();
  for (const double error : {0.1, 0.3, 5.0}) {
    add(given, turn);
    addRevisit(0, path_views - 1, {error, 0, 0});
    EXPECT_LT(errorAfter(), 1.2 * without) << error;
    EXPECT_EQ(adjustment_.getReport().revisits_dropped, 1U) << error;
    EXPECT_EQ(adjustment_.getReport().outcome, AdjustmentOutcome::Adjusted) << error;
  }
}

TEST_F(AdjustedRevisits, oneWrongDoesNotTakeTheRightAlong)
{
  const double turn = 0.006;
  add(AdjustmentRoom::drifted(truth_, turn, action_length, 3), turn);
  addRevisit(0, path_views - 1);
  addRevisit(1, path_views - 1);
  addRevisit(0, path_views - 2, {0, 0.15, 0});
  addRevisit(1, path_views - 2);
  EXPECT_LT(errorAfter(), 0.003);
  EXPECT_EQ(adjustment_.getReport().revisits_used, 3U);
  EXPECT_EQ(adjustment_.getReport().revisits_dropped, 1U);
}

/** Half a metre at the other end, where planes are taken for others. */
TEST_F(AdjustedRevisits, aLargeDriftIsClosed)
{
  const double turn = 0.05; // radians
  const RevisitPoses given = AdjustmentRoom::drifted(truth_, turn, action_length, 5);
  add(given, turn);
  const double without = errorAfter();
  for (std::size_t i = 0; i < 3; ++i)
    addRevisit(i, path_views - 1 - i);
  EXPECT_LT(errorAfter(), 0.2 * without);
  EXPECT_LT(errorAfter(), 0.01);
  EXPECT_EQ(adjustment_.getReport().revisits_used, 3U);
}

TEST_F(AdjustedRevisits, threadsDoNotChangeAByte)
{
  const double turn = 0.006;
  const RevisitPoses given = AdjustmentRoom::drifted(truth_, turn, action_length, 3);
  std::vector<RevisitPoses> found;
  for (const unsigned threads : {1U, 2U, 8U}) {
    add(given, turn);
    addRevisit(0, path_views - 1);
    addRevisit(2, path_views - 2, {0, 0.3, 0});
    adjustment_.setNumberOfThreads(threads);
    adjustment_.compute();
    found.push_back(poses());
  }
  for (const RevisitPoses& other : found)
    for (std::size_t i = 0; i < path_views; ++i)
      EXPECT_EQ(
          std::memcmp(other[i].data(), found[0][i].data(), sizeof(Eigen::Matrix4d)), 0);
}

TEST_F(AdjustedRevisits, uglyOnesAreRefused)
{
  const Eigen::Matrix<double, 6, 6> covariance =
      Eigen::Matrix<double, 6, 6>::Identity();
  const Eigen::Isometry3d still = Eigen::Isometry3d::Identity();
  add(truth_, 0.006);
  EXPECT_THROW(adjustment_.addRevisit(0, path_views, still, covariance),
               BadArgumentException);
  EXPECT_THROW(adjustment_.addRevisit(3, 3, still, covariance), BadArgumentException);
  EXPECT_THROW(adjustment_.addRevisit(4, 3, still, covariance), BadArgumentException);
  EXPECT_THROW(adjustment_.addRevisit(0, 3, still, 0 * covariance),
               BadArgumentException);
  Eigen::Isometry3d nowhere = still;
  nowhere.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(adjustment_.addRevisit(0, 3, nowhere, covariance), BadArgumentException);
  EXPECT_EQ(adjustment_.getNumberOfRevisits(), 0U);
  adjustment_.addRevisit(0, 3, still, covariance);
  adjustment_.clear();
  EXPECT_EQ(adjustment_.getNumberOfRevisits(), 0U);
}

} // namespace
} // namespace pcl::acmap::test
