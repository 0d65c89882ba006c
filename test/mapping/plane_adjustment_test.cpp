#include "adjustment_room.h"

#include <pcl/core/trajectory_error.h>
#include <pcl/mapping/plane_adjustment.h>

#include <gtest/gtest.h>

#include <cstring>

namespace pcl::acmap::test {
namespace {

using Adjustment = PlaneAdjustment<PointXYZRGBSigma>;
using Poses = std::vector<Eigen::Isometry3d>;

constexpr double sigma = 0.005, turn = 0.006, length = 0.01; // metres, radians
constexpr std::size_t views = 16;

/** The room from all poses of its path, given with or without drift. */
class PlaneAdjustmentRoom : public testing::Test {
protected:
  PlaneAdjustmentRoom()
  {
    for (std::size_t i = 0; i < truth_.size(); ++i)
      clouds_.push_back(AdjustmentRoom::view(truth_[i], sigma, i + 1));
  }

  void
  add(const Poses& given)
  {
    adjustment_.clear();
    for (std::size_t i = 0; i < given.size(); ++i)
      adjustment_.addPointCloud(clouds_[i], given[i]);
    adjustment_.setOdometryNoise({length, 0, turn, 0});
  }

  Poses
  adjusted()
  {
    adjustment_.compute();
    Poses poses;
    for (std::size_t i = 0; i < adjustment_.getNumberOfPointClouds(); ++i)
      poses.push_back(adjustment_.getPose(i));
    return poses;
  }

  const Poses truth_ = AdjustmentRoom::path(views);
  const Poses given_ = AdjustmentRoom::drifted(truth_, turn, length, 3);
  std::vector<PointCloud<PointXYZRGBSigma>::ConstPtr> clouds_;
  Adjustment adjustment_;
};

TEST_F(PlaneAdjustmentRoom, driftInSixDegreesOfFreedomIsRemoved)
{
  add(given_);
  const Poses found = adjusted();
  const double before = absoluteTrajectoryError(given_, truth_).unaligned;
  const double after = absoluteTrajectoryError(found, truth_).unaligned;
  EXPECT_GT(before, 0.03);
  EXPECT_LT(after, 0.1 * before);
  EXPECT_LT(after, 0.003);
  const PlaneAdjustmentReport& report = adjustment_.getReport();
  EXPECT_EQ(report.outcome, AdjustmentOutcome::Adjusted);
  EXPECT_LT(report.thickness_after, 0.1 * report.thickness_before);
  EXPECT_LT(report.thickness_after, 0.003) << "the recess was laid onto its wall";
  EXPECT_GT(report.landmarks, 20U);
  EXPECT_GE(report.associated_pieces, 2 * report.landmarks);
}

/** It includes systematic errors of at least 0.2 mm for each view of a plane, which these
 * views do not have. */
TEST_F(PlaneAdjustmentRoom, uncertaintyIsAboveTheErrors)
{
  add(given_);
  const Poses found = adjusted();
  const auto& uncertainty = adjustment_.getReport().uncertainty;
  ASSERT_EQ(uncertainty.size(), views);
  EXPECT_EQ(uncertainty.front().position, 0);
  double squares = 0;
  for (std::size_t i = 1; i < views; ++i) {
    const double error = (found[i].translation() - truth_[i].translation()).norm();
    squares += std::pow(error / uncertainty[i].position, 2) / (views - 1);
    EXPECT_GT(uncertainty[i].position, 1e-5);
    EXPECT_LT(uncertainty[i].position, 0.01);
  }
  EXPECT_GT(squares, 0.01);
  EXPECT_LT(squares, 1);
}

TEST_F(PlaneAdjustmentRoom, rightPosesAreKept)
{
  add(truth_);
  const Poses found = adjusted();
  EXPECT_EQ(adjustment_.getReport().outcome, AdjustmentOutcome::Kept)
      << adjustment_.getReport().significance;
  for (std::size_t i = 0; i < views; ++i)
    EXPECT_EQ(found[i].matrix(), truth_[i].matrix());
}

TEST_F(PlaneAdjustmentRoom, anyOdometryNoiseIsLegal)
{
  const double before = absoluteTrajectoryError(given_, truth_).unaligned;
  for (const double told : {0.3, 3.0}) {
    add(given_);
    adjustment_.setOdometryNoise({told * length, 0, told * turn, 0});
    EXPECT_LT(absoluteTrajectoryError(adjusted(), truth_).unaligned, 0.2 * before)
        << told;
  }
}

TEST_F(PlaneAdjustmentRoom, threadsDoNotChangeAByte)
{
  add(given_);
  adjustment_.setNumberOfThreads(1);
  const Poses wanted = adjusted();
  for (const unsigned threads : {2U, 8U}) {
    adjustment_.setNumberOfThreads(threads);
    const Poses found = adjusted();
    for (std::size_t i = 0; i < views; ++i)
      EXPECT_EQ(std::memcmp(found[i].data(), wanted[i].data(), sizeof(Eigen::Matrix4d)),
                0);
  }
}

TEST_F(PlaneAdjustmentRoom, covariancesOfActionsReplaceTheNoise)
{
  add(given_);
  ActionCovariance covariance = ActionCovariance::Zero();
  covariance.diagonal() << turn * turn, turn * turn, turn * turn, length * length,
      length * length, length * length;
  adjustment_.setActionCovariances(
      std::vector<ActionCovariance>(views - 1, covariance));
  const Poses found = adjusted();
  EXPECT_LT(absoluteTrajectoryError(found, truth_).unaligned, 0.003);
  adjustment_.setActionCovariances({covariance});
  EXPECT_THROW(adjustment_.compute(), BadArgumentException);
  for (std::size_t i = 0; i < views; ++i)
    EXPECT_EQ(adjustment_.getPose(i).matrix(), found[i].matrix());
}

TEST_F(PlaneAdjustmentRoom, oneViewAndUglyViewsKeepTheirPoses)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  add({given_[0]});
  adjusted();
  EXPECT_EQ(adjustment_.getReport().outcome, AdjustmentOutcome::Undetermined);
  PointCloud<PointXYZRGBSigma>::Ptr missing(
      new PointCloud<PointXYZRGBSigma>(*clouds_[0]));
  PointCloud<PointXYZRGBSigma>::Ptr same(new PointCloud<PointXYZRGBSigma>(*missing));
  PointCloud<PointXYZRGBSigma>::Ptr scattered(
      new PointCloud<PointXYZRGBSigma>(*missing));
  Random random(1);
  for (std::size_t i = 0; i < missing->size(); ++i) {
    (*missing)[i].x = (*missing)[i].y = (*missing)[i].z = nan;
    (*same)[i].x = (*same)[i].y = (*same)[i].z = 1;
    for (float& coordinate : (*scattered)[i].data)
      coordinate = static_cast<float>(random.uniform(-5, 5));
  }
  for (const auto& ugly : {missing, same, scattered}) {
    adjustment_.clear();
    for (std::size_t i = 0; i < 3; ++i)
      adjustment_.addPointCloud(ugly, given_[i]);
    const Poses found = adjusted();
    EXPECT_NE(adjustment_.getReport().outcome, AdjustmentOutcome::Adjusted);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(found[i].matrix(), given_[i].matrix());
  }
}

TEST_F(PlaneAdjustmentRoom, viewsMayBeLoadedWhenNeeded)
{
  add(given_);
  const Poses wanted = adjusted();
  Adjustment lazy;
  lazy.setOdometryNoise({length, 0, turn, 0});
  for (std::size_t i = 0; i < views; ++i)
    lazy.addPointCloudLoader([this, i] { return clouds_[i]; }, given_[i]);
  lazy.compute();
  for (std::size_t i = 0; i < views; ++i)
    EXPECT_EQ(lazy.getPose(i).matrix(), wanted[i].matrix());
  EXPECT_EQ(lazy.getConcatenatedCloud()->size(), views * clouds_[0]->size());
}

} // namespace
} // namespace pcl::acmap::test
