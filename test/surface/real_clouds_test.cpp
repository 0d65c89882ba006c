#include "dewall_runs.h"
#include "test_data.h"

#include <pcl/conversions.h>
#include <pcl/core/point_cloud_file.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

struct MeshedCloud {
  std::string name;
  std::string path;
  double min_used;     ///< fraction of the valid, distinct points that have triangles
  double max_boundary; ///< fraction of the edges with one triangle
};

void
PrintTo(const MeshedCloud& cloud, std::ostream* stream)
{
  *stream << cloud.path;
}

class DeWallOnRealCloud : public testing::TestWithParam<MeshedCloud> {
protected:
  void
  SetUp() override
  {
    if (!hasTestData(GetParam().path))
      GTEST_SKIP() << "no " << GetParam().path << " in ACMAP_TEST_DATA";
    fromPCLPointCloud2(loadPointCloud(testDataPath(GetParam().path).string()).cloud,
                       cloud_);
  }

  Cloud cloud_;
};

TEST_P(DeWallOnRealCloud, keepsEveryGuarantee)
{
  for (const DeWallRule rule : {DeWallRule::Guarded, DeWallRule::Dense}) {
    const DeWallRun run{rule, 0, 0};
    const DeWallResult result = triangulate(cloud_, run);
    EXPECT_TRUE(keepsGuarantees(result, run)) << nameOf(rule);
    const DeWallReport& report = result.report;
    const auto valid = static_cast<double>(report.points - report.invalid_points -
                                           report.duplicate_points);
    EXPECT_GE(static_cast<double>(report.used_points), GetParam().min_used * valid)
        << nameOf(rule);
    EXPECT_LE(static_cast<double>(report.boundary_edges),
              GetParam().max_boundary * static_cast<double>(report.edges))
        << nameOf(rule);
  }
}

TEST_P(DeWallOnRealCloud, sameBytesForEveryNumberOfThreads)
{
  const TriangleMesh one =
      triangulateInLeaves(cloud_, {DeWallRule::Guarded, 0, 1}, 5000).mesh;
  const TriangleMesh all =
      triangulateInLeaves(cloud_, {DeWallRule::Guarded, 0, 8}, 5000).mesh;
  EXPECT_EQ(one.triangles, all.triangles);
}

INSTANTIATE_TEST_SUITE_P(
    Data,
    DeWallOnRealCloud,
    testing::Values(
        MeshedCloud{
            "mug", "E_meshing/table_scene_mug_stereo_textured.pcd", 0.99, 0.025},
        MeshedCloud{"office", "E_meshing/office1.pcd", 0.99, 0.13},
        MeshedCloud{"capture", "E_meshing/capture0001.pcd", 0.99, 0.14},
        MeshedCloud{"bun0", "E_meshing/bun0.pcd", 0.9, 0.3},
        MeshedCloud{"bunny", "E_meshing/stanford-bunny.obj", 0.99, 0.03},
        MeshedCloud{"room_scan", "C_sequence/pcl_room_scans/room_scan1.pcd", 0.5, 0.5}),
    [](const auto& info) { return info.param.name; });

} // namespace
} // namespace pcl::acmap::test
