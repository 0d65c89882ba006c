#include "consolidation_runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>

namespace pcl::acmap::test {
namespace {

NoisyCloud
makeRoomOfTwoViews()
{
  NoisyCloud cloud = makeNoisyRoom(150, 0.01, 71);
  cloud.viewpoints.emplace_back(1.3F, 0.4F, 0.2F);
  for (std::size_t i = 0; i < cloud.view.size(); i += 2)
    cloud.view[i] = 1;
  return cloud;
}

void
expectSameBytes(const Consolidated& a, const Consolidated& b)
{
  ASSERT_EQ(a.cloud.size(), b.cloud.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.cloud.size(); ++i)
    different +=
        std::memcmp(a.cloud[i].data, b.cloud[i].data, sizeof a.cloud[i].data) ||
        std::memcmp(a.cloud[i].data_n, b.cloud[i].data_n, 3 * sizeof(float)) ||
        std::memcmp(a.cloud[i].data_c, b.cloud[i].data_c, 3 * sizeof(float));
  EXPECT_EQ(different, 0U) << "of " << a.cloud.size();
}

TEST(Invariance, threadsDoNotChangeAByte)
{
  NoisyCloud cloud = makeNoisyRoom(1500, 0.01, 73); // 650 000 points
  const Consolidated alone = consolidate(cloud, 0.08, 1);
  ASSERT_GT(alone.cloud.size(), 10000U);
  for (const unsigned threads : {2U, 8U}) {
    const Consolidated found = consolidate(cloud, 0.08, threads);
    expectSameBytes(found, alone);
    EXPECT_EQ(found.sources.indices, alone.sources.indices);
    EXPECT_EQ(found.sources.offsets, alone.sources.offsets);
    EXPECT_EQ(found.voxel_of_point, alone.voxel_of_point);
  }
}

TEST(Invariance, threadsDoNotChangeTheAutomaticVoxel)
{
  const NoisyCloud cloud = makeRoomOfTwoViews();
  const Consolidated alone = consolidate(cloud, 0, 1);
  expectSameBytes(consolidate(cloud, 0, 8), alone);
}

TEST(Invariance, orderOfThePointsDoesNotMatter)
{
  const NoisyCloud cloud = makeRoomOfTwoViews();
  const NoisyCloud mixed = shuffled(cloud, 3);
  for (const double voxel : {0.2, 0.0}) {
    const Consolidated found = consolidate(cloud, voxel);
    const Consolidated other = consolidate(mixed, voxel);
    EXPECT_EQ(found.report.voxel_size, other.report.voxel_size);
    ASSERT_EQ(found.cloud.size(), other.cloud.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < found.cloud.size(); ++i)
      different += found.cloud[i].getVector3fMap() != other.cloud[i].getVector3fMap() ||
                   found.cloud[i].getNormalVector3fMap() !=
                       other.cloud[i].getNormalVector3fMap() ||
                   found.cloud[i].view != other.cloud[i].view;
    EXPECT_EQ(different, 0U) << "of " << found.cloud.size();
  }
}

TEST(Invariance, wholeVoxelsMoveTheOutput)
{
  constexpr float voxel = 0.125;
  NoisyCloud cloud = makeRoomOfTwoViews();
  for (Eigen::Vector3f& point : cloud.points) // so that the shifted coordinates are
                                              // exact too
    point = (point * 65536).array().round().matrix() / 65536;
  for (Eigen::Vector3f& viewpoint : cloud.viewpoints)
    viewpoint = (viewpoint * 65536).array().round().matrix() / 65536;
  const Eigen::Vector3f shift(37 * voxel, -81 * voxel, 5 * voxel);
  NoisyCloud there = cloud;
  for (Eigen::Vector3f& point : there.points)
    point += shift;
  for (Eigen::Vector3f& viewpoint : there.viewpoints)
    viewpoint += shift;
  const Consolidated found = consolidate(cloud, voxel);
  const Consolidated moved = consolidate(there, voxel);
  ASSERT_EQ(found.cloud.size(), moved.cloud.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < found.cloud.size(); ++i)
    different +=
        (found.cloud[i].getVector3fMap() + shift - moved.cloud[i].getVector3fMap())
                .norm() > 1e-5F ||
        (found.cloud[i].getNormalVector3fMap() - moved.cloud[i].getNormalVector3fMap())
                .norm() > 1e-4F;
  EXPECT_EQ(different, 0U) << "of " << found.cloud.size();
  different = 0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    different += found.voxel_of_point[i] != moved.voxel_of_point[i];
  EXPECT_EQ(different, 0U) << "of " << cloud.points.size() << " points";
}

TEST(Invariance, farFromTheOriginIsAsGood)
{
  NoisyCloud cloud;
  cloud.viewpoints = {{500001, 4000000, 5}};
  Random random(5);
  for (int i = 0; i < 40000; ++i)
    cloud.points.emplace_back(static_cast<float>(500000 + random.uniform(0, 20)),
                              static_cast<float>(4000000 + random.uniform(0, 20)),
                              static_cast<float>(0.02 * random.normal()));
  cloud.view.assign(cloud.points.size(), 0);
  const Consolidated found = consolidate(cloud, 1);
  EXPECT_EQ(found.report.distant_points, 0U);
  EXPECT_NEAR(static_cast<double>(found.cloud.size()), 420, 40);
  for (const MapPoint& point : found.cloud) {
    EXPECT_NEAR(point.z, 0, 0.01);
    EXPECT_GT(point.normal_z, 0.99);
  }
}

} // namespace
} // namespace pcl::acmap::test
