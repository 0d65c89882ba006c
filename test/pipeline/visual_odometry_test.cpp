#include "room_views.h"
#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/visual_odometry.h>

#include <gmock/gmock.h>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

/** A walk through a painted room, as a folder. */
class CameraWalk : public testing::Test {
protected:
  static constexpr std::size_t views = 4;

  static Eigen::Isometry3d
  poseAt(std::size_t i)
  {
    const auto step = static_cast<double>(i);
    return poseOf({-0.3 + 0.05 * step, 0, -0.5 + 0.1 * step}, 0.1 + 0.03 * step);
  }

  CameraWalk()
  {
    const Room room;
    for (std::size_t i = 0; i < views; ++i)
      write(i, *viewOf(room, poseAt(i)));
  }

  void
  write(std::size_t i, const PointCloud<PointXYZRGBSigma>& view) const
  {
    PCLPointCloud2 cloud;
    toPCLPointCloud2(view, cloud);
    saveObservation(
        folder_.path(observationName(i)), cloud, Eigen::Isometry3d::Identity());
  }

  TemporaryFolder folder_;
};

TEST_F(CameraWalk, isFollowed)
{
  VisualOdometry odometry;
  std::vector<std::size_t> kept;
  odometry.setPoseCallback([&](std::size_t index,
                               const PointCloudFile&,
                               const Eigen::Isometry3d&) { kept.push_back(index); });
  const ObservationSequence sequence(folder_.path(""));
  const VisualOdometryResult found = odometry.compute(sequence);
  ASSERT_EQ(found.posed(), views);
  EXPECT_THAT(kept, testing::ElementsAre(0, 1, 2, 3));
  for (std::size_t i = 0; i < views; ++i) {
    const Eigen::Isometry3d truth = poseAt(0).inverse() * poseAt(i);
    EXPECT_LT((found.poses[i]->translation() - truth.translation()).norm(), 0.02) << i;
  }
  EXPECT_EQ(found.free.pairs, 3U);
  EXPECT_EQ(found.free.free, 0U) << "it moves level";
  EXPECT_EQ(sequence.getNumberOfReads(), views);
}

TEST_F(CameraWalk, isFollowedPastABlankView)
{
  PointCloud<PointXYZRGBSigma> blank = *viewOf(Room(), poseAt(2));
  for (PointXYZRGBSigma& point : blank)
    point.rgba = 0xff808080;
  write(2, blank);
  VisualOdometry odometry;
  std::size_t tried = 0;
  odometry.setPairCallback(
      [&](const OdometryPair&, const VisualOdometry::Egomotion&) { ++tried; });
  const ObservationSequence sequence(folder_.path(""));
  const VisualOdometryResult found = odometry.compute(sequence);
  EXPECT_EQ(found.posed(), views - 1);
  EXPECT_FALSE(found.poses[2]);
  EXPECT_THAT(found.reasonOf(2, sequence.names()), HasSubstr("observation_000"));
  EXPECT_EQ(found.estimated({0, 1, 2, 3}).trajectory.stamps,
            (std::vector<double>{0, 1, 3}));
  EXPECT_EQ(tried, found.pairs.size());
}

TEST_F(CameraWalk, refusesViewsOfAnotherSize)
{
  write(1, PointCloud<PointXYZRGBSigma>(8, 8));
  VisualOdometry odometry;
  EXPECT_THROW(odometry.compute(ObservationSequence(folder_.path(""))),
               InputFileException);
}

TEST_F(CameraWalk, canBeCancelled)
{
  VisualOdometry odometry;
  odometry.setProgressCallback(
      [](double done, const std::string&) { return done < 0.4; });
  EXPECT_THROW(odometry.compute(ObservationSequence(folder_.path(""))),
               CancelledException);
}

} // namespace
} // namespace pcl::acmap::test
