#include "boxed_hall.h"

#include <pcl/conversions.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/random.h>
#include <pcl/pipeline/visual_odometry.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace pcl::acmap::test {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using testing::HasSubstr;

using Clouds = std::vector<std::shared_ptr<const PointCloudFile>>;

BoxedHall
furnished()
{
  return {{Vector3d(-4, -3, 0), Vector3d(5, 4, 2.6)},
          {{Vector3d(1, -2, 0), Vector3d(2, -1, 1.2)},
           {Vector3d(-3, 2, 0), Vector3d(-2.2, 4, 2)},
           {Vector3d(3, 1, 0), Vector3d(4, 3, 0.7)}}};
}

/** A scan of so many rings, of one row, without colours. */
std::shared_ptr<const PointCloudFile>
scanOf(const BoxedHall& hall, const Isometry3d& pose, int rings, std::uint64_t seed)
{
  constexpr int columns = 400;
  constexpr double reach = 10, noise = 0.008;
  Random random(seed);
  PointCloud<PointXYZ> cloud;
  for (int column = 0; column < columns; ++column)
    for (int ring = 0; ring < rings; ++ring) {
      const double turn = 2 * M_PI * column / columns,
                   rise = (ring - (rings - 1) / 2.0) * 60 / rings * M_PI / 180;
      const Vector3d ray(std::cos(rise) * std::cos(turn) + 1e-9,
                         std::cos(rise) * std::sin(turn) + 1e-9,
                         std::sin(rise) + 1e-9);
      const double range = hall.range(pose.translation(), pose.linear() * ray);
      if (range > reach)
        continue;
      PointXYZ point;
      point.getVector3fMap() = ((range + noise * random.normal()) * ray).cast<float>();
      cloud.push_back(point);
    }
  const auto file = std::make_shared<PointCloudFile>();
  toPCLPointCloud2(cloud, file->cloud);
  return file;
}

std::vector<Isometry3d>
walk(std::size_t size)
{
  std::vector<Isometry3d> poses;
  for (std::size_t i = 0; i < size; ++i) {
    const auto t = static_cast<double>(i);
    Isometry3d pose(Eigen::AngleAxisd(0.2 * t, Vector3d::UnitZ()) *
                    Eigen::AngleAxisd(0.02 * std::sin(t), Vector3d::UnitX()));
    pose.translation() << -2 + 0.5 * t, 0.3 * std::sin(t), 1.1 + 0.02 * std::cos(2 * t);
    poses.push_back(pose);
  }
  return poses;
}

TEST(ScanOdometry, FollowsScansWithoutImages)
{
  const std::vector<Isometry3d> truth = walk(6);
  for (const int rings : {16, 64}) {
    Clouds clouds;
    for (std::size_t i = 0; i < truth.size(); ++i)
      clouds.push_back(scanOf(furnished(), truth[i], rings, i));
    VisualOdometry odometry;
    const VisualOdometryResult found = odometry.compute(ObservationSequence(clouds));
    EXPECT_EQ(found.model, MotionModel::Rigid);
    ASSERT_EQ(found.posed(), truth.size()) << rings;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const Isometry3d error =
          found.poses[i]->inverse() * truth[0].inverse() * truth[i];
      EXPECT_LT(error.translation().norm(), 0.05) << rings << " rings, scan " << i;
      EXPECT_LT(Eigen::AngleAxisd(error.linear()).angle(), 0.01)
          << rings << " rings, scan " << i;
    }
    odometry.setNumberOfThreads(1);
    const VisualOdometryResult again = odometry.compute(ObservationSequence(clouds));
    for (std::size_t i = 0; i < truth.size(); ++i)
      EXPECT_EQ(again.poses[i]->matrix(), found.poses[i]->matrix());
  }
}

/** Nothing shows how far the sensor went: no motion is better than an assumed one. */
TEST(ScanOdometry, HasNoMotionAlongABareCorridor)
{
  const BoxedHall corridor{{Vector3d(-100, -1, 0), Vector3d(100, 1, 2.5)}, {}};
  Clouds clouds;
  for (int i = 0; i < 2; ++i) {
    Isometry3d pose = Isometry3d::Identity();
    pose.translation() << 0.8 * i, 0, 1;
    clouds.push_back(scanOf(corridor, pose, 32, static_cast<std::uint64_t>(i)));
  }
  const VisualOdometryResult found =
      VisualOdometry().compute(ObservationSequence(clouds));
  EXPECT_EQ(found.posed(), 0U);
  ASSERT_FALSE(found.pairs.empty());
  EXPECT_THAT(
      found.pairs.front().report.outcome,
      testing::AnyOf(EgomotionOutcome::Unobservable, EgomotionOutcome::Inconsistent));
}

TEST(ScanOdometry, RefusesWhatHasNoSurface)
{
  PointCloud<PointXYZ> one;
  one.push_back({1, 2, 3});
  const auto file = std::make_shared<PointCloudFile>();
  toPCLPointCloud2(one, file->cloud);
  const VisualOdometryResult found =
      VisualOdometry().compute(ObservationSequence(Clouds{file, file}));
  EXPECT_EQ(found.posed(), 0U);
  EXPECT_THAT(found.reasonOf(0, {"a", "b"}), HasSubstr("hardly any surface"));
}

TEST(ScanOdometry, NeedsImagesInPaperMode)
{
  const Clouds clouds(2, scanOf(furnished(), walk(1)[0], 16, 1));
  VisualOdometry odometry;
  VisualOdometry::Egomotion egomotion;
  egomotion.setPaperMode(true);
  odometry.setEgomotion(egomotion);
  try {
    odometry.compute(ObservationSequence(clouds));
    FAIL() << "the paper's egomotion compares images";
  }
  catch (const InputFileException& exception) {
    EXPECT_THAT(exception.what(), HasSubstr("has no image"));
  }
}

} // namespace
} // namespace pcl::acmap::test
