#include "adjustment_room.h"

#include <pcl/core/trajectory_error.h>
#include <pcl/mapping/plane_adjustment.h>

#include <gtest/gtest.h>

#include <cmath>
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

/** Views of the plain wall, floor and ceiling: no plane tells where the camera is along
 * the wall. */
TEST(AdjustmentAlongAWall, isDeterminedByARevisit)
{
  constexpr double turn = 0.006, way_error = 0.03; // radians, metres
  RevisitPoses truth;
  for (std::size_t i = 0; i < path_views; ++i) {
    Eigen::Isometry3d pose(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitY()));
    const auto half = static_cast<double>(path_views) / 2;
    pose.translation().x() = 1 - std::abs(static_cast<double>(i) - half) / half;
    truth.push_back(pose);
  }
  const RevisitPoses given = AdjustmentRoom::drifted(truth, turn, way_error, 4);
  double errors[2] = {};
  for (const bool is_seen_again : {false, true}) {
    PlaneAdjustment<PointXYZRGBSigma> adjustment;
    adjustment.setOdometryNoise({way_error, 0, turn, 0});
    for (std::size_t i = 0; i < path_views; ++i) {
      const auto cloud = AdjustmentRoom::view(truth[i], view_sigma, i + 1);
      for (PointXYZRGBSigma& point : *cloud)
        if (std::abs(point.x) > 0.5F * point.z) // a side wall, from some places
          point.getVector3fMap().setConstant(std::numeric_limits<float>::quiet_NaN());
      adjustment.addPointCloud(cloud, given[i]);
    }
    if (is_seen_again)
      adjustment.addRevisit(0,
                            path_views - 1,
                            truth[0].inverse() * truth[path_views - 1],
                            1e-6 * Eigen::Matrix<double, 6, 6>::Identity());
    adjustment.compute();
    EXPECT_EQ(adjustment.getReport().outcome, AdjustmentOutcome::Adjusted);
    errors[is_seen_again] =
        std::abs(adjustment.getPose(path_views - 1).translation().x() -
                 truth[path_views - 1].translation().x());
  }
  EXPECT_GT(errors[false], 0.03);
  EXPECT_LT(errors[true], 0.012) << "a centimetre is assumed for errors of whole views";
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
