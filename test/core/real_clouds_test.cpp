#include "cloud_values.h"
#include "test_data.h"

#include <pcl/core/point_cloud_file.h>
#include <pcl/io/obj_io.h>
#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

/** A real file, read by PCL and by acmap. */
class RealCloud : public testing::TestWithParam<const char*> {
protected:
  void
  SetUp() override
  {
    if (!hasTestData(GetParam()))
      GTEST_SKIP() << GetParam() << " is not in the folder that ACMAP_TEST_DATA names";
  }
};

TEST_P(RealCloud, isReadAsPclReadsIt)
{
  const std::string path = testDataPath(GetParam()).string();
  const PointCloudFile file = loadPointCloud(path);
  PCLPointCloud2 by_pcl;
  if (path.substr(path.size() - 4) == ".obj") {
    ASSERT_EQ(OBJReader().read(path, by_pcl), 0);
    for (const char* name : {"x", "y", "z"})
      EXPECT_EQ(bytesOf(file.cloud, name), bytesOf(by_pcl, name)) << name;
  }
  else {
    ASSERT_EQ(PCDReader().read(path, by_pcl), 0);
    const auto together = {"x", "y", "z"};
    if (std::equal(together.begin(), together.end(), namesOf(by_pcl).begin()))
      expectEqual(file.cloud, by_pcl);
    else
      for (const std::string& name : namesOf(by_pcl))
        EXPECT_EQ(bytesOf(file.cloud, name), bytesOf(by_pcl, name)) << name;
  }
  EXPECT_TRUE(file.remarks.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Data,
    RealCloud,
    testing::Values("E_meshing/bun0.pcd",
                    "E_meshing/capture0001.pcd",
                    "E_meshing/capture0002.pcd",
                    "E_meshing/office1.pcd",
                    "E_meshing/sac_plane_test.pcd",
                    "E_meshing/table_scene_mug_stereo_textured.pcd",
                    "E_meshing/fandisk.obj",
                    "E_meshing/stanford-bunny.obj",
                    "C_sequence/pcl_room_scans/room_scan1.pcd",
                    "C_sequence/pcl_room_scans/room_scan2.pcd",
                    "F_planes/mosd/learn0.pcd",
                    "F_planes/navvis_room1/room1_gt_fine.pcd",
                    "F_planes/synpeb/test_100.pcd"));

} // namespace
} // namespace pcl::acmap::test
