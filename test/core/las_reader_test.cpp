#include "cloud_values.h"
#include "las_file.h"
#include "temporary_folder.h"
#include "test_data.h"

#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_cloud_reader.h>

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

PointCloudFile
loadFrom(const TemporaryFolder& folder, const LasFile& las)
{
  return loadPointCloud(folder.write("cloud.las", las.bytes));
}

TEST(LasReader, AllVersionsAndFormatsHaveTheirPoints)
{
  const TemporaryFolder folder;
  for (int minor = 0; minor <= 5; ++minor)
    for (int format = 0; format <= (minor >= 4 ? 10 : 5); ++format) {
      LasFile las(minor, format);
      const std::size_t classification = format < 6 ? 15 : 16;
      for (std::size_t i = 0; i < las.points; ++i) {
        las.set<std::uint16_t>(las.at(i) + 12, static_cast<std::uint16_t>(60000 + i));
        las.set<std::uint8_t>(las.at(i) + classification,
                              static_cast<std::uint8_t>(i + 2));
      }
      const PointCloudFile file = loadFrom(folder, las);
      ASSERT_EQ(file.points().size(), las.points) << minor << " " << format;
      EXPECT_TRUE(file.shift.isZero(0));
      EXPECT_EQ(file.up, Eigen::Vector3f(0, 0, 1)) << "it names no sensor";
      for (std::size_t i = 0; i < las.points; ++i) {
        EXPECT_LT((file.points()[i].cast<double>() - las.position(i)).norm(), 1e-6);
        EXPECT_EQ(valueOf<float>(file.cloud, "intensity", i),
                  60000.0F + static_cast<float>(i));
        EXPECT_EQ(valueOf<std::uint8_t>(file.cloud, "classification", i), i + 2);
      }
      constexpr std::array<bool, 11> colored = {
          false, false, true, true, false, true, false, true, true, false, true};
      EXPECT_EQ(findField(file.cloud, "rgb") != nullptr,
                colored[static_cast<std::size_t>(format)]);
    }
}

TEST(LasReader, ColoursMayHaveEightBitsOrSixteen)
{
  const TemporaryFolder folder;
  for (const std::uint16_t unit : {1, 256}) {
    LasFile las(2, 2);
    for (std::uint16_t c = 0; c < 3; ++c)
      las.set<std::uint16_t>(las.at(1) + 20 + 2 * c,
                             static_cast<std::uint16_t>((10 + c) * unit));
    const PointCloudFile file = loadFrom(folder, las);
    EXPECT_EQ(valueOf<std::uint32_t>(file.cloud, "rgb", 1) & 0xFFFFFF, 0x0A0B0CU)
        << unit;
    EXPECT_EQ(valueOf<std::uint32_t>(file.cloud, "rgb", 0) & 0xFFFFFF, 0U);
  }
}

/** The first colour that needs 16 bits is blocks behind those that look like 8 bits. */
TEST(LasReader, LateColoursOfSixteenBitsAreThoseOfAllPoints)
{
  const TemporaryFolder folder;
  LasFile las(2, 2, Eigen::Vector3d::Zero(), 30000);
  for (std::size_t i = 0; i < las.points; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      las.set<std::uint16_t>(las.at(i) + 20 + 2 * c,
                             static_cast<std::uint16_t>(i < 20000 ? 200 : i + c));
  const PointCloudFile file = loadFrom(folder, las);
  for (std::size_t i = 0; i < las.points; ++i) {
    const auto level = [&](std::size_t c) { return i < 20000 ? 0 : (i + c) >> 8; };
    ASSERT_EQ(valueOf<std::uint32_t>(file.cloud, "rgb", i) & 0xFFFFFF,
              level(0) << 16 | level(1) << 8 | level(2))
        << i;
    ASSERT_LT((file.points()[i].cast<double>() - las.position(i)).norm(), 2e-3);
  }
}

TEST(LasReader, NationalGridsKeepTheirMillimetres)
{
  const TemporaryFolder folder;
  const LasFile las(2, 0, Eigen::Vector3d(635619.25, -5848899.5, 412.125));
  const PointCloudFile file = loadFrom(folder, las);
  EXPECT_EQ(file.shift, Eigen::Vector3d(635000, -5849000, 0));
  for (std::size_t i = 0; i < las.points; ++i)
    EXPECT_LT((file.points()[i].cast<double>() + file.shift - las.position(i)).norm(),
              2e-4);
  ASSERT_EQ(file.remarks.size(), 1U);
  EXPECT_THAT(file.remarks[0], HasSubstr("635000, -5849000, 0"));
  PointCloudFile scaled = file;
  scaleCloud(scaled, 0.5);
  EXPECT_EQ(scaled.shift, file.shift / 2);
}

TEST(LasReader, PointsThatWereNotMeasuredDoNotDecideTheShift)
{
  const TemporaryFolder folder;
  LasFile las(2, 0, Eigen::Vector3d(635619.25, 5848899.5, 412.125));
  const Eigen::Vector3i nowhere(-635619250, -1, -412125);
  for (std::size_t axis = 0; axis < 3; ++axis)
    las.set<std::int32_t>(las.at(0) + 4 * axis, nowhere[static_cast<int>(axis)]);
  las.set(155 + 8, 0.001); // the first point is (0, 0, 0), the others near it in y
  const PointCloudFile file = loadFrom(folder, las);
  EXPECT_EQ(file.shift, Eigen::Vector3d(635000, 0, 0));
  EXPECT_FALSE(file.points()[0].allFinite());
  EXPECT_TRUE(file.points()[1].allFinite());
  EXPECT_EQ(file.cloud.is_dense, 0);
  EXPECT_THAT(file.remarks,
              testing::Contains(HasSubstr("1 of its points are at (0, 0, 0)")));
}

/** \brief A record of a reference system, behind the header of LAS 1.2. */
std::string
projectionRecord(std::uint16_t number, const std::string& content)
{
  std::string record(54, '\0');
  std::memcpy(&record[2], "LASF_Projection", 15);
  std::memcpy(&record[18], &number, sizeof number);
  const auto size = static_cast<std::uint16_t>(content.size());
  std::memcpy(&record[20], &size, sizeof size);
  return record + content;
}

std::string
geoKeys(const std::vector<std::array<std::uint16_t, 4>>& keys)
{
  std::string text(8, '\0');
  for (const auto& key : keys)
    text.append(reinterpret_cast<const char*>(key.data()), sizeof key);
  return text;
}

/** \brief A LAS 1.2 whose points are (0, 1, 2) mm and so on of its unit, with records. */
LasFile
lasWithRecords(const std::string& records)
{
  LasFile las(2, 0);
  const std::size_t header = 227;
  las.bytes.insert(header, records);
  las.set(96, static_cast<std::uint32_t>(header + records.size() + 10));
  return las;
}

const std::string projected_in_feet =
    R"(PROJCS["here",GEOGCS["GCS",UNIT["degree",0.0174532925199433]],)"
    R"(PARAMETER["false_easting",1312335.958],UNIT["US survey foot", 0.3048006096012192,)"
    R"(AUTHORITY["EPSG","9003"]],AXIS["E",EAST]])";

/** \brief What reads the record, and metres of a unit of x and y, and of z. */
struct UnitRecord {
  std::string record;
  double across, up;
};

TEST(LasReader, UnitsOfItsRecordsBecomeMetres)
{
  const double us_foot = 1200.0 / 3937;
  double own = 0.5;
  const std::string numbers(reinterpret_cast<const char*>(&own), sizeof own);
  for (const UnitRecord& unit : std::vector<UnitRecord>{
           {projectionRecord(34735, geoKeys({{1024, 0, 1, 1}, {3076, 0, 1, 9001}})),
            1,
            1},
           {projectionRecord(34735, geoKeys({{3076, 0, 1, 9002}})), 0.3048, 0.3048},
           {projectionRecord(34735, geoKeys({{3076, 0, 1, 9003}, {4099, 0, 1, 9001}})),
            us_foot,
            1},
           {projectionRecord(34735,
                             geoKeys({{3076, 0, 1, 32767}, {3077, 34736, 1, 0}})) +
                projectionRecord(34736, numbers),
            0.5,
            0.5},
           {projectionRecord(2112, projected_in_feet), us_foot, us_foot},
           {projectionRecord(2112,
                             R"(COMPD_CS["both",PROJCS["m",UNIT["metre",1]],)"
                             R"(VERT_CS["h",VERT_DATUM["d",2005],UNIT["ft",0.3048]]])"),
            1,
            0.3048},
           {projectionRecord(2112,
                             R"(PROJCRS["new",CONVERSION["c",PARAMETER["e",1,)"
                             R"(LENGTHUNIT["metre",1]]],CS[Cartesian,2],)"
                             R"(AXIS["e",east,LENGTHUNIT["foot",0.3048]]])"),
            0.3048,
            0.3048}}) {
    const LasFile las = lasWithRecords(unit.record);
    const TemporaryFolder folder;
    const PointCloudFile file = loadFrom(folder, las);
    ASSERT_TRUE(file.stated_scale);
    EXPECT_NEAR(*file.stated_scale, unit.across, 1e-8);
    for (std::size_t i = 0; i < las.points; ++i) {
      const Eigen::Vector3d expected = las.position(i).cwiseProduct(
          Eigen::Vector3d(unit.across, unit.across, unit.up));
      EXPECT_LT((file.points()[i].cast<double>() - expected).norm(), 1e-6);
    }
    EXPECT_EQ(file.remarks.size(), unit.across == 1 && unit.up == 1 ? 0U : 1U);
  }
}

TEST(LasReader, StatedScalesHoldAgainstItsRecords)
{
  const TemporaryFolder folder;
  const LasFile las = lasWithRecords(projectionRecord(2112, projected_in_feet));
  PointCloudReader reader;
  reader.setScale(1);
  const PointCloudFile file = reader.read(folder.write("cloud.las", las.bytes));
  EXPECT_LT((file.points()[3].cast<double>() - las.position(3)).norm(), 1e-6);
}

TEST(LasReader, ReferenceSystemsWithoutAUnitAreTold)
{
  const TemporaryFolder folder;
  const PointCloudFile file =
      loadFrom(folder,
               lasWithRecords(projectionRecord(
                   34735, geoKeys({{1024, 0, 1, 1}, {3072, 0, 1, 2263}}))));
  EXPECT_FALSE(file.stated_scale);
  EXPECT_THAT(file.remarks, testing::ElementsAre(HasSubstr("EPSG:2263")));
}

TEST(LasReader, DegreesAreRefused)
{
  const TemporaryFolder folder;
  const std::string geographic = R"(GEOGCS["WGS 84",UNIT["degree",0.017453292519943]])";
  for (const std::string& record :
       {projectionRecord(2112, geographic),
        projectionRecord(34735, geoKeys({{1024, 0, 1, 2}, {2054, 0, 1, 9102}}))}) {
    LasFile las = lasWithRecords(record);
    EXPECT_THAT([&] { loadFrom(folder, las); },
                testing::ThrowsMessage<InputFileException>(HasSubstr("degrees")));
    las.set(179, 635000.0); // the bounds show another system
    EXPECT_EQ(loadFrom(folder, las).points().size(), las.points);
  }
}

TEST(LasReader, DamagedRecordsTellNoUnit)
{
  const TemporaryFolder folder;
  for (const std::string& record :
       {projectionRecord(2112, "PROJCS[UNIT[\"foot\""),
        projectionRecord(2112, "UNIT[\"foot\",0.3]]]]"),
        projectionRecord(2112, "PROJCS[\"x\",UNIT[\"foot\",1e300]]"),
        projectionRecord(2112, std::string(3000, '[')),
        projectionRecord(34735, geoKeys({{3076, 0, 1, 9002}})).substr(0, 60),
        projectionRecord(34735, geoKeys({{3077, 34736, 1, 65535}})),
        std::string(20, '\1')}) {
    const LasFile las = lasWithRecords(record);
    const PointCloudFile file = loadFrom(folder, las);
    EXPECT_FALSE(file.stated_scale) << record;
    EXPECT_LT((file.points()[3].cast<double>() - las.position(3)).norm(), 1e-6);
  }
}

/** Writers of streams, and those that were killed, leave the number at 0. */
TEST(LasReader, PointsAreCountedThatItsHeaderDoesNotClaim)
{
  const TemporaryFolder folder;
  for (const int minor : {2, 4}) {
    LasFile las(minor, 0);
    las.set<std::uint32_t>(107, 0);
    if (minor >= 4)
      las.set<std::uint64_t>(247, 0);
    las.bytes += "end"; // of a point
    const PointCloudFile file = loadFrom(folder, las);
    ASSERT_EQ(file.points().size(), las.points);
    EXPECT_LT((file.points()[4].cast<double>() - las.position(4)).norm(), 1e-6);
    EXPECT_THAT(file.remarks, testing::ElementsAre(HasSubstr("claims no points, 5")));
  }
  LasFile las(4, 0);
  las.set<std::uint64_t>(247, 0);
  las.set<std::uint64_t>(235, las.at(2)); // what follows are records
  EXPECT_EQ(loadFrom(folder, las).points().size(), 2U);
  las.set<std::uint64_t>(235, las.at(0));
  EXPECT_EQ(loadFrom(folder, las).points().size(), 0U);
}

TEST(LasReader, UglyFilesAreRefusedWithTheirFault)
{
  const TemporaryFolder folder;
  const auto expectFault = [&](const LasFile& las, const char* fault) {
    EXPECT_THAT([&] { loadFrom(folder, las); },
                testing::ThrowsMessage<InputFileException>(HasSubstr(fault)))
        << fault;
  };
  LasFile las(2, 0);
  las.bytes[0] = 'X';
  expectFault(las, "no LAS file");
  las = LasFile(2, 0);
  las.set<std::uint8_t>(25, 6);
  expectFault(las, "LAS 1.6");
  las = LasFile(2, 0);
  las.set<std::uint8_t>(104, 0x80);
  expectFault(las, "packed by LASzip");
  las = LasFile(2, 0);
  las.set<std::uint8_t>(104, 11);
  expectFault(las, "format 11");
  las = LasFile(2, 0);
  las.set<std::uint16_t>(105, 19);
  expectFault(las, "claims points of 19 bytes");
  las = LasFile(2, 0);
  las.set<std::uint32_t>(107, 4000000000U);
  expectFault(las, "4000000000");
  las = LasFile(4, 6);
  las.set<std::uint64_t>(247, ~std::uint64_t{0});
  expectFault(las, "points");
  las = LasFile(2, 0);
  las.set(131, std::nan(""));
  expectFault(las, "scale");
  las = LasFile(2, 0);
  las.set<std::uint32_t>(96, 100);
  expectFault(las, "within its header");
  las = LasFile(2, 0);
  las.set<std::uint32_t>(96, 100000);
  expectFault(las, "ends before its points");
  for (std::size_t size : {0, 3, 100, 226, 240, 260}) {
    las = LasFile(2, 0);
    las.bytes.resize(size);
    EXPECT_THROW(loadFrom(folder, las), InputFileException) << size;
  }
  EXPECT_THROW(loadPointCloud(folder.write("cloud.laz", LasFile(2, 0).bytes)),
               InputFileException);
}

/** The points are within the bounds of the header, and reach them. */
TEST(LasReader, FilesOfOthersHaveTheirBounds)
{
  if (!hasTestData("G_formats/las/1.0_0.las"))
    GTEST_SKIP() << "G_formats/las is not in the folder that ACMAP_TEST_DATA names";
  for (const char* name : {"1.0_0.las",
                           "1.0_1.las",
                           "1.1_0.las",
                           "1.1_1.las",
                           "1.2_0.las",
                           "1.2_1.las",
                           "1.2_2.las",
                           "1.2_3.las",
                           "100-points.las",
                           "autzen_trim.las",
                           "autzen-bmx-2010.las",
                           "bad_vlr_count.las",
                           "gps-time-nan.las",
                           "test1_4.las"}) {
    const std::string path =
        testDataPath(std::string("G_formats/las/") + name).string();
    std::array<char, 375> header{};
    std::ifstream(path, std::ios::binary).read(header.data(), header.size());
    const auto number = [&](std::size_t offset) {
      double value = 0;
      std::memcpy(&value, &header[offset], sizeof value);
      return value;
    };
    const PointCloudFile file = loadPointCloud(path);
    std::uint32_t count = 0;
    std::memcpy(&count, &header[107], sizeof count);
    if (count == 0) // of LAS 1.4
      std::memcpy(&count, &header[247], sizeof count);
    EXPECT_EQ(file.points().size(), count) << name;
    Eigen::AlignedBox3d box;
    const double unit = file.stated_scale.value_or(1);
    const bool has_feet_up = name == std::string("autzen-bmx-2010.las");
    const Eigen::Vector3d metres(unit, unit, has_feet_up ? 1200.0 / 3937 : unit);
    for (std::size_t i = 0; i < file.points().size(); ++i)
      box.extend((file.points()[i].cast<double>() + file.shift).cwiseQuotient(metres));
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double step =
          std::max(std::abs(number(131 + 8 * static_cast<std::size_t>(axis))), 0.001);
      EXPECT_NEAR(
          box.max()[axis], number(179 + 16 * static_cast<std::size_t>(axis)), step)
          << name;
      EXPECT_NEAR(
          box.min()[axis], number(187 + 16 * static_cast<std::size_t>(axis)), step)
          << name;
    }
  }
  for (const char* name : {"simple.laz", "1.2-no-points.las"}) // the latter claims 1065
    EXPECT_THROW(
        loadPointCloud(testDataPath(std::string("G_formats/las/") + name).string()),
        InputFileException)
        << name;
}

} // namespace
} // namespace pcl::acmap::test
