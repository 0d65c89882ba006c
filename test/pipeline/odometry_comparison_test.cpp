#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/odometry_comparison.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

std::vector<Eigen::Isometry3d>
wayAhead(std::size_t size, double step)
{
  std::vector<Eigen::Isometry3d> poses(size, Eigen::Isometry3d::Identity());
  for (std::size_t i = 0; i < size; ++i)
    poses[i].translation().z() = step * static_cast<double>(i);
  return poses;
}

TEST(OdometryComparison, FirstPosedObservationHasItsTruePose)
{
  VisualOdometryResult found;
  found.poses.emplace_back(); // lost
  for (const Eigen::Isometry3d& pose : wayAhead(4, 1.1))
    found.poses.emplace_back(pose);
  std::vector<Eigen::Isometry3d> truth = wayAhead(5, 1);
  const Eigen::Isometry3d elsewhere(Eigen::Translation3d(7, 0, 0) *
                                    Eigen::AngleAxisd(1, Eigen::Vector3d::UnitY()));
  for (Eigen::Isometry3d& pose : truth)
    pose = elsewhere * pose;
  const OdometryComparison comparison = compareWithTruth(found, truth);
  EXPECT_TRUE(comparison.is_moving);
  EXPECT_EQ(comparison.truth.size(), 5U);
  EXPECT_TRUE(comparison.truth[1].isApprox(Eigen::Isometry3d::Identity(), 1e-9));
  EXPECT_EQ(comparison.relative.pairs, 3U);
  EXPECT_NEAR(comparison.relative.translation_per_metre, 0.1, 1e-9);
  EXPECT_NEAR(comparison.absolute.unaligned, std::sqrt((0.01 + 0.04 + 0.09) / 4), 1e-9);
}

TEST(OdometryFigures, AreMediansOfThePairsWithAMotion)
{
  VisualOdometryResult found;
  for (const Eigen::Isometry3d& pose : wayAhead(4, 2))
    found.poses.emplace_back(pose);
  found.poses.insert(found.poses.begin() + 1, std::nullopt); // lost
  for (const int factor : {1, 2, 9}) {
    OdometryPair& pair = found.pairs.emplace_back();
    pair.report.matches = static_cast<std::size_t>(100 * factor);
    pair.report.inliers = static_cast<std::size_t>(10 * factor);
    pair.report.fits = 2;
    pair.estimate.emplace();
    pair.estimate->covariance.setZero();
    pair.estimate->covariance(0, 0) = pair.estimate->covariance(2, 2) = factor * factor;
  }
  found.pairs.emplace_back().report.matches = 7; // without a motion
  const OdometryFigures figures = figuresOf(found);
  EXPECT_DOUBLE_EQ(figures.length, 6);
  EXPECT_EQ(figures.matches, 200);
  EXPECT_EQ(figures.inliers, 20);
  EXPECT_EQ(figures.fits, 6U);
  EXPECT_DOUBLE_EQ(figures.x, 2);
  EXPECT_DOUBLE_EQ(figures.translation, std::sqrt(8));
  EXPECT_EQ(figures.rotation, 0);
  EXPECT_EQ(figuresOf({}).matches, 0);
}

TEST(OdometryComparison, NeedsAPoseAndATruthOfEach)
{
  VisualOdometryResult found;
  found.poses.resize(2);
  EXPECT_THROW(compareWithTruth(found, wayAhead(2, 1)), BadArgumentException);
  found.poses[0] = Eigen::Isometry3d::Identity();
  EXPECT_THROW(compareWithTruth(found, wayAhead(3, 1)), BadArgumentException);
  EXPECT_FALSE(compareWithTruth(found, wayAhead(2, 1)).is_moving);
}

TEST(OdometryComparison, RowsOfTheTruthAreFoundByNumbers)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("truth.txt");
  saveTrajectory(path, {{0, 1, 2}, wayAhead(3, 1)});
  std::vector<std::string> remarks;
  EXPECT_EQ(loadTruePoses(path, {"a", "b", "c"}, 0.1, remarks)[2].translation().z(),
            0.2);
  EXPECT_TRUE(remarks.empty());
  const auto found =
      loadTruePoses(path, {"observation_0002.pcd", "observation_0000.pcd"}, 1, remarks);
  EXPECT_EQ(found[0].translation().z(), 2);
  EXPECT_EQ(remarks.size(), 1U);
  EXPECT_THROW(loadTruePoses(path, {"a", "b"}, 1, remarks), InputFileException);
}

} // namespace
} // namespace pcl::acmap::test
