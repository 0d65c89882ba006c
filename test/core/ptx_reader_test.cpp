#include "cloud_values.h"
#include "temporary_folder.h"

#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/scan_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace pcl::acmap::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/** A quarter turn about z, and a place in a national grid. */
const std::string turned = "0 1 0 0\n-1 0 0 0\n0 0 1 0\n452000.25 10 3 1\n";
const std::string axes = "452000.25 10 3\n0 1 0\n-1 0 0\n0 0 1\n";

/** Two columns of three rows; the second point was not measured. */
std::string
gridOf(const std::string& size)
{
  return size + axes + turned +
         "1 0 0 0.5 255 0 0\n0 0 0 0.5 0 0 0\n3 0 0 0.25 0 0 9\n"
         "4 0 0 0.5 0 255 0\n5 0 0 0.5 0 0 0\n6 0 0 0.5 0 0 0\n";
}

TEST(PtxReader, AGridIsAnOrganizedCloudInTheFrameOfTheFile)
{
  const TemporaryFolder folder;
  const PointCloudFile file = loadPointCloud(folder.write("a.PTX", gridOf("2\n3\n")));
  ASSERT_EQ(file.cloud.width, 2U);
  ASSERT_EQ(file.cloud.height, 3U);
  EXPECT_EQ(file.shift, Eigen::Vector3d(452000, 0, 0));
  EXPECT_EQ(file.points()[1], Eigen::Vector3f(0.25F, 14, 3)) << "x turned to y";
  EXPECT_FALSE(file.points()[2].allFinite());
  EXPECT_EQ(file.points()[4], Eigen::Vector3f(0.25F, 13, 3));
  EXPECT_EQ(valueOf<float>(file.cloud, "intensity", 4), 0.25F);
  EXPECT_EQ(valueOf<std::uint32_t>(file.cloud, "rgb", 1) & 0xFFFFFF, 0x00FF00U);
  EXPECT_EQ(file.sensor_origin, Eigen::Vector3f(0.25F, 10, 3));
}

TEST(PtxReader, AGridThatIsNotWhatItClaimsIsNotOrganized)
{
  const TemporaryFolder folder;
  const PointCloudFile file =
      loadPointCloud(folder.write("a.ptx", gridOf("4444\n10014\n")));
  EXPECT_EQ(file.cloud.height, 1U);
  EXPECT_EQ(file.points().size(), 6U);
  EXPECT_THAT(file.remarks, Contains(HasSubstr("claims 4444 x 10014 points")));
}

TEST(PtxReader, ScansAreObservationsWithTheirPoses)
{
  const TemporaryFolder folder;
  const std::string path = folder.write("two.ptx", gridOf("2\n3\n") + gridOf("3\n2\n"));
  EXPECT_EQ(ScanFile::count(path), 2U);
  const ScanFile scans(path);
  const PointCloudFile whole = loadPointCloud(path);
  EXPECT_EQ(scans.shift(), whole.shift);
  EXPECT_EQ(scans.load(1).cloud.width, 3U);
  EXPECT_EQ(valueOf<std::int32_t>(whole.cloud, "view", 6), 1);
  ASSERT_EQ(whole.viewpoints.size(), 2U);
  const PointCloudFile scan = scans.load(0);
  EXPECT_EQ(scan.points()[0], Eigen::Vector3f(0, 0, 1)) << "ahead of the camera";
  EXPECT_LT((scans.pose(0) * scan.points()[0].cast<double>() -
             whole.points()[0].cast<double>())
                .norm(),
            1e-4);
  EXPECT_THAT(scans.remarks(), IsEmpty());
  const ScanFile stated(path, Eigen::Vector3d(452000.25, 10, 3));
  EXPECT_LT(stated.pose(0).translation().norm(), 1e-9);
}

} // namespace
} // namespace pcl::acmap::test
