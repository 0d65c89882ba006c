#include "cloud_values.h"
#include "e57_file.h"
#include "las_file.h"
#include "sanitized.h"
#include "temporary_folder.h"
#include "test_data.h"

#include <pcl/conversions.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_types.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <sys/resource.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace pcl::acmap::test {
namespace {

TEST(ScaledCloud, ScalesAllThatIsALength)
{
  PointCloud<PointXYZRGBSigma> points(2, 1);
  points[1].getVector3fMap() << 1000, -2000, 3000;
  points[1].sigma = 20;
  points[1].rgba = 0xff123456;
  PointCloudFile file;
  toPCLPointCloud2(points, file.cloud);
  file.sensor_origin << 500, 0, 0;
  scaleCloud(file, 0.001);
  PointCloud<PointXYZRGBSigma> scaled;
  fromPCLPointCloud2(file.cloud, scaled);
  EXPECT_EQ(scaled[1].getVector3fMap(), Eigen::Vector3f(1, -2, 3));
  EXPECT_FLOAT_EQ(scaled[1].sigma, 0.02F);
  EXPECT_EQ(scaled[1].rgba, points[1].rgba);
  EXPECT_EQ(file.sensor_origin.x(), 0.5F);
}

/** Files of all encodings with 30,000 points, which are several blocks. */
std::vector<std::string>
writeEncodings(const PCLPointCloud2& cloud)
{
  const std::string folder = testing::TempDir();
  std::vector<std::string> paths;
  for (const char* name : {"rows_ascii.pcd",
                           "rows_binary.pcd",
                           "rows_packed.pcd",
                           "rows_ascii.ply",
                           "rows_binary.ply"})
    paths.push_back(folder + name);
  const Eigen::Vector4f origin(1, 2, 3, 0);
  const Eigen::Quaternionf turn = Eigen::Quaternionf::Identity();
  PCDWriter pcd;
  pcd.writeASCII(paths[0], cloud, origin, turn);
  pcd.writeBinary(paths[1], cloud, origin, turn);
  pcd.writeBinaryCompressed(paths[2], cloud, origin, turn);
  PLYWriter ply;
  ply.writeASCII(paths[3], cloud, origin, turn, 8, false);
  ply.writeBinary(paths[4], cloud, origin, turn, false);
  return paths;
}

void
expectRowsOfCloud(const std::string& path)
{
  for (const double scale : {1.0, 0.001}) {
    const PointCloudFile expected = loadStatedCloud(path, {scale, {}, {}, false});
    PointCloudFile file;
    const CloudRows rows = loadCloudRows(path, {scale, {}, {}, false}, file);
    EXPECT_TRUE(file.cloud.data.empty()) << path;
    EXPECT_TRUE(rows.copy().data == expected.cloud.data) << path;
    EXPECT_EQ(rows.layout().width, expected.cloud.width) << path;
    EXPECT_EQ(rows.layout().height, expected.cloud.height) << path;
    EXPECT_EQ(rows.layout().is_dense, expected.cloud.is_dense) << path;
    EXPECT_EQ(file.sensor_origin, expected.sensor_origin) << path;
    EXPECT_EQ(file.shift, expected.shift) << path;
    EXPECT_EQ(file.viewpoints, expected.viewpoints) << path;
    EXPECT_EQ(file.remarks, expected.remarks) << path;
  }
}

TEST(CloudRowsOfAFile, AreThoseOfItsCloud)
{
  PointCloud<PointXYZRGBSigma> points(300, 100);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].getVector3fMap() << 0.5F * static_cast<float>(i), 3, -1;
    points[i].sigma = static_cast<float>(i % 7);
    points[i].rgba = static_cast<std::uint32_t>(i);
  }
  points[5].x = std::numeric_limits<float>::quiet_NaN();
  PCLPointCloud2 cloud;
  toPCLPointCloud2(points, cloud);
  for (const std::string& path : writeEncodings(cloud))
    expectRowsOfCloud(path);
  PointCloudFile none;
  EXPECT_THROW(loadCloudRows("/no/such.pcd", {}, none), InputFileException);
}

/** A scan of 200 rows, written column by column from right to left, with holes. */
WrittenScan
gridScan()
{
  std::vector<Eigen::Vector3d> points;
  BitStream rows, columns;
  for (std::uint64_t column = 200; column-- > 0;)
    for (std::uint64_t row = 0; row < 200; ++row) {
      if ((row * 7 + column) % 11 == 0)
        continue;
      points.emplace_back(452000 + 0.01 * static_cast<double>(column),
                          0.01 * static_cast<double>(row),
                          5);
      rows.add(row, 8);
      columns.add(column, 8);
    }
  WrittenScan scan = scanOf(points);
  for (const char* name : {"rowIndex", "columnIndex"})
    scan.prototype +=
        std::string("<") + name + R"( type="Integer" minimum="0" maximum="255"/>)";
  scan.streams.insert(scan.streams.end(), {rows.bytes, columns.bytes});
  return scan;
}

TEST(CloudRowsOfAFile, AreThoseOfScanners)
{
  const TemporaryFolder folder;
  const LasFile las(4, 7, Eigen::Vector3d(635619.25, -5848899.5, 412.125), 30000);
  expectRowsOfCloud(folder.write("points.las", las.bytes));
  const WrittenScan scan = gridScan();
  const std::string grid = folder.write("grid.e57", e57Of({scan}, 40));
  expectRowsOfCloud(grid);
  expectRowsOfCloud(folder.write("scans.e57", e57Of({scan, scan}, 40)));
  const PointCloudFile file = loadPointCloud(grid);
  ASSERT_EQ(file.cloud.width, 200U);
  ASSERT_EQ(file.cloud.height, 200U);
  for (std::size_t row = 0; row < 200; ++row)
    for (std::size_t column = 0; column < 200; ++column) {
      const Eigen::Vector3f point = file.points()[row * 200 + column];
      if ((row * 7 + column) % 11 == 0)
        ASSERT_TRUE(point.array().isNaN().all());
      else
        ASSERT_LT((point - Eigen::Vector3f(0.01F * static_cast<float>(column),
                                           0.01F * static_cast<float>(row),
                                           5))
                      .norm(),
                  1e-3F);
    }
}

/** Limits the memory of this process to what it has, and \a more bytes. */
void
limitMemory(std::size_t more)
{
  std::ifstream status("/proc/self/status");
  std::size_t kilobytes = 0;
  for (std::string word; status >> word;)
    if (word == "VmData:")
      status >> kilobytes;
  rlimit both = {};
  if (kilobytes == 0 || ::getrlimit(RLIMIT_DATA, &both) != 0)
    std::abort();
  both.rlim_cur = 1024 * kilobytes + more;
  if (::setrlimit(RLIMIT_DATA, &both) != 0)
    std::abort();
}

TEST(CloudRowsOfAFile, OfScannersAreReadInLessMemoryThanThey)
{
  if (is_sanitized)
    GTEST_SKIP() << "a sanitizer has memory of its own";
  constexpr std::size_t points = 1000000, memory = std::size_t{6} << 20;
  const TemporaryFolder folder;
  std::vector<std::string> paths;
  {
    const LasFile las(2, 2, Eigen::Vector3d::Zero(), points);
    paths.push_back(folder.write("points.las", las.bytes));
    const std::vector<Eigen::Vector3d> places(points, Eigen::Vector3d(1, 2, 3));
    paths.push_back(folder.write("points.e57", e57Of({scanOf(places)}, 1000)));
  }
  for (const std::string& path : paths)
    EXPECT_EXIT(
        {
          const ScratchMemory scratch(testing::TempDir(), std::size_t{16} << 20);
          limitMemory(memory);
          PointCloudFile file;
          const CloudRows rows = loadCloudRows(path, {}, file);
          std::_Exit(rows.size() == points && rows.bytes() > memory ? 0 : 1);
        },
        testing::ExitedWithCode(0),
        "");
}

TEST(CloudRowsOfAFile, AreThoseOfRealScanners)
{
  namespace fs = std::filesystem;
  if (!hasTestData("G_formats/las/1.0_0.las"))
    GTEST_SKIP() << "G_formats is not in the folder that ACMAP_TEST_DATA names";
  std::size_t read = 0;
  for (const auto& entry :
       fs::recursive_directory_iterator(testDataPath("G_formats"))) {
    const std::string path = entry.path().string();
    const fs::path ending = entry.path().extension();
    if (ending != ".las" && ending != ".e57")
      continue;
    try {
      expectRowsOfCloud(path);
      ++read;
    }
    catch (const InputFileException&) {
      PointCloudFile none;
      EXPECT_THROW(loadCloudRows(path, {}, none), InputFileException) << path;
    }
  }
  EXPECT_GE(read, 20U);
}

} // namespace
} // namespace pcl::acmap::test
