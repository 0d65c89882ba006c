#include "cloud_values.h"
#include "e57_file.h"
#include "temporary_folder.h"
#include "test_data.h"

#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/scan_file.h>

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

/** Points (i, 2 i, -i) cm as integers of 13 bits, with colours and an intensity. */
WrittenScan
integerScan(std::size_t count)
{
  WrittenScan scan;
  scan.count = count;
  const std::string integer =
      R"( type="ScaledInteger" minimum="-4096" maximum="4095" scale="0.01"/>)";
  for (const char* name : {"cartesianX", "cartesianY", "cartesianZ"})
    scan.prototype += std::string("<") + name + integer;
  scan.prototype += R"(<intensity type="Float" precision="single"/>)";
  for (const char* name : {"colorRed", "colorGreen", "colorBlue"})
    scan.prototype +=
        std::string("<") + name + R"( type="Integer" minimum="0" maximum="255"/>)";
  std::array<BitStream, 7> streams;
  for (std::size_t i = 0; i < count; ++i) {
    const auto number = static_cast<std::int64_t>(i);
    for (const auto& [axis, value] :
         {std::pair(0, number), {1, 2 * number}, {2, -number}})
      streams[static_cast<std::size_t>(axis)].add(
          static_cast<std::uint64_t>(value + 4096), 13);
    std::uint32_t bits = 0;
    const float intensity = 0.5F + static_cast<float>(i);
    std::memcpy(&bits, &intensity, sizeof bits);
    streams[3].add(bits, 32);
    for (std::size_t c = 0; c < 3; ++c)
      streams[4 + c].add(i + c, 8);
  }
  for (const BitStream& stream : streams)
    scan.streams.push_back(stream.bytes);
  return scan;
}

TEST(E57Reader, PackedIntegersAreReadAcrossPackets)
{
  const TemporaryFolder folder;
  for (const std::size_t packets : {1, 2, 7}) {
    const PointCloudFile file =
        loadPointCloud(folder.write("scan.e57", e57Of({integerScan(150)}, packets)));
    ASSERT_EQ(file.points().size(), 150U);
    for (std::size_t i = 0; i < 150; ++i) {
      const auto n = static_cast<float>(i);
      EXPECT_LT((file.points()[i] - 0.01F * Eigen::Vector3f(n, 2 * n, -n)).norm(),
                1e-6F);
      EXPECT_EQ(valueOf<float>(file.cloud, "intensity", i), 0.5F + n);
      EXPECT_EQ(valueOf<std::uint32_t>(file.cloud, "rgb", i),
                i << 16 | (i + 1) << 8 | (i + 2));
    }
    EXPECT_FALSE(findField(file.cloud, "view"));
  }
}

TEST(E57Reader, ScansComeWithTheirPoses)
{
  const TemporaryFolder folder;
  const std::vector<Eigen::Vector3d> points = {{1, 2, 3}, {4, 5, 6}};
  const std::string turned =
      "<pose><rotation><w>0.7071067811865476</w><z>0.7071067811865476"
      "</z></rotation><translation><x>452000.25</x><y>10</y>"
      "</translation></pose>";
  const PointCloudFile file = loadPointCloud(folder.write(
      "scans.e57", e57Of({scanOf(points, turned), scanOf(points, turned)})));
  ASSERT_EQ(file.points().size(), 4U);
  EXPECT_EQ(file.shift, Eigen::Vector3d(451000, 0, 0));
  ASSERT_EQ(file.viewpoints.size(), 2U);
  EXPECT_EQ(file.viewpoints[1], Eigen::Vector3f(1000.25F, 10, 0));
  EXPECT_EQ(file.sensor_origin, file.viewpoints[0]);
  // a quarter turn about z: (1, 2, 3) to (-2, 1, 3)
  EXPECT_LT((file.points()[0] - Eigen::Vector3f(998.25F, 11, 3)).norm(), 1e-3F);
  EXPECT_EQ(valueOf<std::int32_t>(file.cloud, "view", 1), 0);
  EXPECT_EQ(valueOf<std::int32_t>(file.cloud, "view", 2), 1);
}

TEST(E57Reader, RowsAndColumnsMakeAnOrganizedCloud)
{
  const TemporaryFolder folder;
  WrittenScan scan = scanOf({{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}});
  BitStream rows, columns, invalid;
  for (std::size_t i = 0; i < 5; ++i) {
    rows.add(i / 3, 8);
    columns.add(2 - i % 3, 8);
    invalid.add(i == 1 ? 2 : 0, 2);
  }
  scan.prototype +=
      R"(<rowIndex type="Integer" minimum="0" maximum="255"/>)"
      R"(<columnIndex type="Integer" minimum="0" maximum="255"/>)"
      R"(<cartesianInvalidState type="Integer" minimum="0" maximum="2"/>)";
  scan.streams.insert(scan.streams.end(), {rows.bytes, columns.bytes, invalid.bytes});
  const PointCloudFile file = loadPointCloud(folder.write("grid.e57", e57Of({scan})));
  ASSERT_EQ(file.cloud.width, 3U);
  ASSERT_EQ(file.cloud.height, 2U);
  EXPECT_EQ(file.cloud.is_dense, 0);
  const float nan = std::nanf("");
  const float expected[] = {3, nan, 1, nan, 5, 4};
  for (std::size_t i = 0; i < 6; ++i)
    if (std::isnan(expected[i]))
      EXPECT_TRUE(std::isnan(file.points()[i].x())) << i;
    else
      EXPECT_EQ(file.points()[i].x(), expected[i]) << i;
}

TEST(E57Reader, SphericalCoordinatesAreConverted)
{
  const TemporaryFolder folder;
  WrittenScan scan = scanOf({{2, 0.5, -0.25}});
  scan.prototype = R"(<sphericalRange type="Float"/><sphericalAzimuth type="Float"/>)"
                   R"(<sphericalElevation type="Float"/>)";
  const PointCloudFile file = loadPointCloud(folder.write("ball.e57", e57Of({scan})));
  const Eigen::Vector3d expected(2 * std::cos(-0.25) * std::cos(0.5),
                                 2 * std::cos(-0.25) * std::sin(0.5),
                                 2 * std::sin(-0.25));
  EXPECT_LT((file.points()[0].cast<double>() - expected).norm(), 1e-6);
}

TEST(E57Reader, UglyFilesAreRefusedWithTheirFault)
{
  const TemporaryFolder folder;
  const auto expectFault = [&](const std::string& bytes, const char* fault) {
    EXPECT_THAT([&] { loadPointCloud(folder.write("ugly.e57", bytes)); },
                testing::ThrowsMessage<InputFileException>(HasSubstr(fault)))
        << fault;
  };
  const std::string whole = e57Of({integerScan(150)});
  std::string changed = whole;
  changed[0] = 'B';
  expectFault(changed, "no E57 file");
  changed = whole;
  changed[100] = static_cast<char>(~changed[100]);
  expectFault(changed, "checksum of page 0");
  expectFault(whole.substr(0, whole.size() - 1), "truncated");
  expectFault(whole.substr(0, 100), "shorter");
  WrittenScan scan = integerScan(150);
  scan.count = 151;
  expectFault(e57Of({scan}), "151 points has");
  scan.count = 4000000000U;
  expectFault(e57Of({scan}), "claims more points");
  scan = integerScan(150);
  scan.streams.pop_back();
  expectFault(e57Of({scan}), "another number of fields");
  scan = scanOf({{1, 2, 3}}, "<pose><rotation><w>0</w></rotation></pose>");
  expectFault(e57Of({scan}), "no unit quaternion");
  scan = scanOf({{1, 2, 3}});
  scan.prototype = R"(<cartesianX type="String"/>)";
  expectFault(e57Of({scan}), "type 'String'");
  scan = scanOf({{1, 2, 3}});
  scan.prototype = R"(<a type="Float"/><b type="Float"/><c type="Float"/>)";
  expectFault(e57Of({scan}), "without coordinates");
  expectFault(e57Of({}), "has no scan");
  // constants take no bits: they cannot make points of nothing
  scan = WrittenScan();
  scan.count = 1000000;
  for (const char* name : {"cartesianX", "cartesianY", "cartesianZ"})
    scan.prototype +=
        std::string("<") + name + R"( type="Integer" minimum="1" maximum="1"/>)";
  scan.streams.resize(3);
  expectFault(e57Of({scan}), "claims more points");
  EXPECT_EQ(
      loadPointCloud(folder.write("none.e57", e57Of({scanOf({})}))).points().size(),
      0U);
}

TEST(ScanFile, ScansAreObservationsWithTheirPoses)
{
  const TemporaryFolder folder;
  const std::vector<Eigen::Vector3d> points = {{1, 2, 3}, {4, 5, 6}};
  const std::string turned =
      "<pose><rotation><w>0.7071067811865476</w><z>0.7071067811865476"
      "</z></rotation><translation><x>452000.25</x><y>10</y>"
      "</translation></pose>";
  const std::string path = folder.write(
      "scans.e57", e57Of({scanOf(points, turned), scanOf(points, turned)}));
  EXPECT_EQ(ScanFile::count(path), 2U);
  const ScanFile scans(path);
  const PointCloudFile whole = loadPointCloud(path);
  EXPECT_EQ(scans.shift(), whole.shift);
  ASSERT_EQ(scans.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const PointCloudFile scan = scans.load(i);
    ASSERT_EQ(scan.points().size(), 2U);
    // right, down and ahead of a scanner that looks along x
    EXPECT_EQ(scan.points()[0], Eigen::Vector3f(-2, -3, 1));
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_LT((scans.pose(i) * scan.points()[k].cast<double>() -
                 whole.points()[2 * i + k].cast<double>())
                    .norm(),
                1e-4);
    EXPECT_EQ(scan.sensor_origin, whole.viewpoints[i]);
  }
}

TEST(ScanFile, PointsFarFromTheirScannerKeepTheirMillimetres)
{
  const TemporaryFolder folder;
  // exported in a national grid, without poses
  const std::vector<Eigen::Vector3d> first = {{452300.125, 5411200.5, 310},
                                              {452301.375, 5411200.5, 310}},
                                     second = {{452299.003, 5411201.002, 311.001}};
  const ScanFile scans(
      folder.write("grid.e57", e57Of({scanOf(first), scanOf(second)})));
  EXPECT_EQ(scans.shift(), Eigen::Vector3d(452000, 5411000, 0));
  const auto place = [&](std::size_t scan, std::size_t point) {
    return (scans.pose(scan) * scans.load(scan).points()[point].cast<double>() +
            scans.shift())
        .eval();
  };
  EXPECT_LT((place(0, 1) - first[1]).norm(), 1e-4);
  EXPECT_LT((place(1, 0) - second[0]).norm(), 1e-4);
}

TEST(ScanFile, ABrokenPageIsNamed)
{
  const TemporaryFolder folder;
  std::string bytes = e57Of({integerScan(150), integerScan(150)});
  bytes[1024 + 30] = static_cast<char>(~bytes[1024 + 30]);
  EXPECT_THAT([&] { const ScanFile scans(folder.write("broken.e57", bytes)); },
              testing::ThrowsMessage<InputFileException>(
                  HasSubstr("checksum of page 1 is wrong")));
}

TEST(E57Reader, FilesOfOthers)
{
  const std::string folder = "G_formats/e57/";
  if (!hasTestData(folder + "bunnyInt32.e57"))
    GTEST_SKIP() << folder << " is not in the folder that ACMAP_TEST_DATA names";
  const auto load = [&](const char* name) {
    return loadPointCloud(testDataPath(folder + name).string());
  };
  const PointCloudFile bunny = load("bunnyInt32.e57");
  ASSERT_EQ(bunny.points().size(), 30571U);
  Eigen::AlignedBox3f box;
  for (std::size_t i = 0; i < bunny.points().size(); ++i)
    if (bunny.points()[i].allFinite())
      box.extend(bunny.points()[i]);
  // the bounds that the file states
  EXPECT_LT((box.min() - Eigen::Vector3f(-0.094689F, 0.040011F, -0.061873F)).norm(),
            1e-6F);
  EXPECT_LT((box.max() - Eigen::Vector3f(0.061009F, 0.187321F, 0.058799F)).norm(),
            1e-6F);
  const PointCloudFile cube = load("ColouredCubeFloat.e57");
  ASSERT_EQ(cube.points().size(), 7680U);
  std::map<std::uint32_t, std::size_t> colors;
  for (std::size_t i = 0; i < cube.points().size(); ++i) {
    EXPECT_LE(cube.points()[i].cwiseAbs().maxCoeff(), 0.5F);
    ++colors[valueOf<std::uint32_t>(cube.cloud, "rgb", i)];
  }
  EXPECT_GE(colors.size(), 3U);
  const PointCloudFile two = load("A_B.e57");
  EXPECT_EQ(two.viewpoints.size(), 2U);
  EXPECT_EQ(load("A_moved_B.e57").points().size(), two.points().size());
  for (const char* name : {"bad-crc.e57", "empty.e57"})
    EXPECT_THROW(load(name), InputFileException) << name;
  for (const char* name :
       {"InvalidCVHeader.e57", "ZeroPoints.e57", "ZeroPointsInvalid.e57"})
    EXPECT_EQ(load(name).points().size(), 0U) << name;
}

} // namespace
} // namespace pcl::acmap::test
