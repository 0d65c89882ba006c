#include "dewall_runs.h"

#include <pcl/conversions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/exceptions.h>

#include <limits>
#include <numeric>

namespace pcl::acmap::test {
namespace {

constexpr std::size_t least_resident = std::size_t{16} << 20;

/** Enough points that nearly all arrays are worth a file, and that walls exist. */
Cloud
noisyPlane()
{
  return makeJitteredPlane({520, 520, 0.01, 0.25, 0.6, 3}).cloud;
}

CloudRows
rowsOf(const Cloud& cloud)
{
  const auto rows = std::make_shared<PCLPointCloud2>();
  toPCLPointCloud2(cloud, *rows);
  return CloudRows(PCLPointCloud2ConstPtr(rows));
}

void
triangulateRows(const CloudRows& rows, DeWallRule rule, TriangleMesh& mesh)
{
  DeWallTriangulation<PCLPointCloud2> dewall;
  dewall.setInputCloud(rows);
  dewall.setAcceptanceRule(rule);
  dewall.setComputeWallDepth(true);
  dewall.reconstruct(mesh);
}

TEST(DeWallInFiles, sameBytesAsInMemory)
{
  const Cloud cloud = noisyPlane();
  const CloudRows rows = rowsOf(cloud);
  for (const DeWallRule rule : {DeWallRule::Guarded, DeWallRule::Dense}) {
    TriangleMesh in_memory, in_files;
    triangulateRows(rows, rule, in_memory);
    const ScratchMemory scratch(testing::TempDir(), least_resident);
    triangulateRows(rows, rule, in_files);
    EXPECT_EQ(scratch.getRefused(), 0U);
    EXPECT_GT(scratch.getBytes(), 100 * cloud.size());
    EXPECT_TRUE(in_files.triangles == in_memory.triangles) << nameOf(rule);
    EXPECT_TRUE(in_files.wall_depth == in_memory.wall_depth) << nameOf(rule);
    EXPECT_GT(in_files.triangles.size(), cloud.size());
  }
}

TEST(DeWallInFiles, countsOnlyWhatStaysInMemory)
{
  constexpr std::size_t points = 100000000;
  const std::size_t all = estimateDeWallMemory(points, true, DeWallRule::Guarded);
  const ScratchMemory scratch(testing::TempDir(), least_resident);
  const std::size_t rest = estimateDeWallMemory(points, true, DeWallRule::Guarded);
  EXPECT_GT(all, std::size_t{17} * 1000 * 1000 * 1000);
  EXPECT_LT(rest, std::size_t{1} * 1000 * 1000 * 1000);
  EXPECT_GT(rest, least_resident);
  EXPECT_EQ(estimateDeWallMemory(points, false, DeWallRule::Strict),
            360 * points + (1 << 20))
      << "its arrays stay";
}

/** Repeated points are searched in groups, if there are many points. */
TEST(DeWallInFiles, repeatedPointsOfALargeCloudAreSkipped)
{
  const Cloud once = noisyPlane();
  Cloud thrice = once;
  for (std::size_t i = once.size(); i-- > 0;)
    thrice.push_back(once[i]);
  thrice += once;
  const DeWallResult of_once = triangulate(once, {}),
                     of_thrice = triangulate(thrice, {});
  EXPECT_EQ(of_thrice.report.duplicate_points, 2 * once.size());
  EXPECT_EQ(of_thrice.report.invalid_points, 0U);
  EXPECT_TRUE(of_thrice.mesh.triangles == of_once.mesh.triangles)
      << "the first of equal points is the vertex";
}

TEST(DeWallRows, sameMeshAsOfTypedPoints)
{
  const Cloud plane = makeJitteredPlane({40, 30, 0.02, 0.2, 0.1, 1}).cloud;
  PointCloud<PointNormal> cloud;
  for (const PointXYZ& point : plane) {
    PointNormal with_normal;
    with_normal.getVector3fMap() = point.getVector3fMap();
    with_normal.getNormalVector3fMap() = -Eigen::Vector3f::UnitZ();
    cloud.push_back(with_normal);
  }
  DeWallTriangulation<PointNormal> of_points;
  of_points.setInputCloud(cloud.makeShared());
  TriangleMesh expected, mesh;
  of_points.reconstruct(expected);

  const auto rows = std::make_shared<PCLPointCloud2>();
  toPCLPointCloud2(cloud, *rows);
  DeWallTriangulation<PCLPointCloud2> dewall;
  dewall.setInputCloud(PCLPointCloud2ConstPtr(rows));
  dewall.setSensorOrigin({0, 0, 5}); // the normals count for more
  dewall.reconstruct(mesh);
  EXPECT_GT(expected.triangles.size(), plane.size());
  EXPECT_TRUE(mesh.triangles == expected.triangles);
  EXPECT_EQ(dewall.getReport().used_points, of_points.getReport().used_points);

  // normals whose fields are in another order
  const auto mixed = std::make_shared<PCLPointCloud2>();
  toPCLPointCloud2(plane, *mixed);
  PCLPointCloud2 wide = withFields(*mixed,
                                   {{"normal_z", PCLPointField::FLOAT32},
                                    {"normal_x", PCLPointField::FLOAT32},
                                    {"normal_y", PCLPointField::FLOAT32}});
  for (std::size_t row = 0; row < plane.size(); ++row)
    setValue(wide, row, findField(wide, "normal_z")->offset, -1.0F);
  dewall.setInputCloud(std::make_shared<const PCLPointCloud2>(std::move(wide)));
  dewall.reconstruct(mesh);
  EXPECT_TRUE(mesh.triangles == expected.triangles);
}

TEST(DeWallRows, facesLookTowardsTheSensor)
{
  const Cloud plane = makeJitteredPlane({40, 30, 0.02, 0.2, 0, 1}).cloud;
  for (const float height : {2.0F, -2.0F}) {
    DeWallTriangulation<PCLPointCloud2> dewall;
    dewall.setInputCloud(rowsOf(plane));
    dewall.setSensorOrigin({0, 0, height});
    TriangleMesh mesh;
    dewall.reconstruct(mesh);
    ASSERT_FALSE(mesh.triangles.empty());
    const auto& [a, b, c] = mesh.triangles.front();
    const Eigen::Vector3f normal =
        (plane[b].getVector3fMap() - plane[a].getVector3fMap())
            .cross(plane[c].getVector3fMap() - plane[a].getVector3fMap());
    EXPECT_GT(normal.z() * height, 0);
  }
}

TEST(DeWallRows, refusesWhatIsNoCloud)
{
  DeWallTriangulation<PCLPointCloud2> dewall;
  TriangleMesh mesh;
  mesh.triangles = {{1, 2, 3}};
  EXPECT_THROW(dewall.reconstruct(mesh), InitFailedException);
  PCLPointCloud2 cloud = rowsOf(noisyPlane()).copy();
  cloud.data.resize(100); // less than it states
  dewall.setInputCloud(std::make_shared<const PCLPointCloud2>(std::move(cloud)));
  EXPECT_THROW(dewall.reconstruct(mesh), InitFailedException);
  EXPECT_EQ(mesh.triangles.size(), 1U) << "a refusal leaves the output alone";
  EXPECT_THROW(dewall.setSensorOrigin({std::numeric_limits<float>::quiet_NaN(), 0, 0}),
               BadArgumentException);
}

} // namespace
} // namespace pcl::acmap::test
