#include "cloud_values.h"
#include "temporary_folder.h"
#include "test_data.h"

#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/point_cloud_file.h>

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

/** Bits of a stream of an E57 file, the lowest first. */
class BitStream {
public:
  void
  add(std::uint64_t value, unsigned bits)
  {
    for (unsigned i = 0; i < bits; ++i, ++count_) {
      if (count_ % 8 == 0)
        bytes.push_back('\0');
      bytes.back() = static_cast<char>(bytes.back() | (value >> i & 1) << (count_ % 8));
    }
  }

  std::string bytes;

private:
  std::size_t count_ = 0;
};

/** A scan as it is written. */
struct WrittenScan {
  std::string prototype, more;
  std::vector<std::string> streams;
  std::size_t count = 0;
};

std::uint32_t
slowChecksum(const std::string& bytes)
{
  std::uint32_t value = ~0U;
  for (const char c : bytes) {
    value ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit)
      value = value & 1 ? value >> 1 ^ 0x82F63B78U : value >> 1;
  }
  return ~value;
}

std::uint64_t
physical(std::uint64_t logical)
{
  return logical / 1020 * 1024 + logical % 1020;
}

/** An E57 file as ASTM E2807 has it; each packet has a part of the streams. */
std::string
e57Of(const std::vector<WrittenScan>& scans, std::size_t packets = 1)
{
  std::string logical(48, '\0'), xml = "<?xml version=\"1.0\"?><e57Root><data3D>";
  for (const WrittenScan& scan : scans) {
    while (logical.size() % 1020 > 900) // an offset must not be within a checksum
      logical.push_back('\0');
    const std::uint64_t section = logical.size();
    std::string body;
    for (std::size_t packet = 0; packet < packets; ++packet) {
      std::string lengths, data;
      for (const std::string& stream : scan.streams) {
        const std::size_t from = stream.size() * packet / packets,
                          to = stream.size() * (packet + 1) / packets;
        lengths += rawBytes(static_cast<std::uint16_t>(to - from));
        data += stream.substr(from, to - from);
      }
      const std::size_t length = 6 + lengths.size() + data.size();
      body +=
          std::string("\1\0", 2) + rawBytes(static_cast<std::uint16_t>(length - 1)) +
          rawBytes(static_cast<std::uint16_t>(scan.streams.size())) + lengths + data;
    }
    logical += std::string("\1\0\0\0\0\0\0\0", 8) +
               rawBytes(std::uint64_t{32 + body.size()}) +
               rawBytes(physical(section + 32)) + rawBytes(std::uint64_t{0}) + body;
    xml += "<vectorChild><points fileOffset=\"" + std::to_string(physical(section)) +
           "\" recordCount=\"" + std::to_string(scan.count) + "\"><prototype>" +
           scan.prototype + "</prototype></points>" + scan.more + "</vectorChild>";
  }
  xml += "</data3D></e57Root>";
  const std::uint64_t at = logical.size();
  logical += xml;
  logical.resize((logical.size() + 1019) / 1020 * 1020);
  const std::string header =
      "ASTM-E57" + rawBytes(1U) + rawBytes(0U) +
      rawBytes(std::uint64_t{logical.size() / 1020 * 1024}) + rawBytes(physical(at)) +
      rawBytes(std::uint64_t{xml.size()}) + rawBytes(std::uint64_t{1024});
  logical.replace(0, 48, header);
  std::string file;
  for (std::size_t page = 0; page < logical.size(); page += 1020) {
    const std::string content = logical.substr(page, 1020);
    const std::uint32_t checksum = slowChecksum(content);
    file += content;
    for (int shift = 24; shift >= 0; shift -= 8)
      file.push_back(static_cast<char>(checksum >> shift & 255));
  }
  return file;
}

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

/** Points of two doubles and a constant. */
WrittenScan
scanOf(const std::vector<Eigen::Vector3d>& points, const std::string& more = {})
{
  WrittenScan scan;
  scan.count = points.size();
  scan.more = more;
  scan.streams.resize(3);
  for (const char* name : {"cartesianX", "cartesianY", "cartesianZ"})
    scan.prototype += std::string("<") + name + R"( type="Float"/>)";
  for (const Eigen::Vector3d& point : points)
    for (std::size_t axis = 0; axis < 3; ++axis)
      scan.streams[axis] += rawBytes(point[static_cast<Eigen::Index>(axis)]);
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
    try {
      loadPointCloud(folder.write("ugly.e57", bytes));
      ADD_FAILURE() << fault;
    }
    catch (const InputFileException& error) {
      EXPECT_THAT(error.what(), HasSubstr(fault));
    }
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
