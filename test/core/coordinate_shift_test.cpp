#include "cloud_values.h"
#include "temporary_folder.h"

#include <pcl/core/point_cloud_reader.h>
#include <pcl/io/pcd_io.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace pcl::acmap::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using Places = std::vector<Eigen::Vector3d>;

const Eigen::Vector3d corner(665305.663, 5648402.759, 248.695);

/** 3000 points of a slope; the first \a zeros are (0, 0, 0). */
Places
slope(const Eigen::Vector3d& at, std::size_t zeros = 0)
{
  Places places(zeros, Eigen::Vector3d::Zero());
  for (std::size_t i = places.size(); i < 3000; ++i)
    places.emplace_back(at + Eigen::Vector3d(0.001 * static_cast<double>(i % 50),
                                             0.002 * static_cast<double>(i / 50),
                                             0.003 * static_cast<double>(i % 7)));
  return places;
}

std::string
textOf(const Places& places, const char* begin = "")
{
  std::string text;
  for (const Eigen::Vector3d& place : places) {
    char row[120];
    std::snprintf(
        row, sizeof row, "%s%.4f %.4f %.4f\n", begin, place.x(), place.y(), place.z());
    text += row;
  }
  return text;
}

template <typename Real>
std::string
binaryOf(const Places& places, bool is_big)
{
  std::string bytes;
  for (const Eigen::Vector3d& place : places)
    for (const double coordinate : place) {
      std::string value = rawBytes(static_cast<Real>(coordinate));
      if (is_big)
        std::reverse(value.begin(), value.end());
      bytes += value;
    }
  return bytes;
}

std::string
plyOf(const std::string& format, const std::string& type, const std::string& data)
{
  return "ply\nformat " + format + " 1.0\nelement vertex 3000\nproperty " + type +
         " x\nproperty " + type + " y\nproperty " + type + " z\nend_header\n" + data;
}

std::string
pcdOf(const std::string& size, const std::string& encoding, const std::string& data)
{
  return "VERSION 0.7\nFIELDS x y z\nSIZE " + size + " " + size + " " + size +
         "\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 3000\nHEIGHT 1\nPOINTS 3000\nDATA " +
         encoding + "\n" + data;
}

/** The places as a file of each format that keeps their digits. */
std::vector<std::string>
filesOf(const Places& places, const TemporaryFolder& folder)
{
  const std::string text = textOf(places);
  std::string grid = "60\n50\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
                     "0 0 0 1\n" +
                     text;
  return {folder.write("a.xyz", text),
          folder.write("a.obj", textOf(places, "v ")),
          folder.write("a.ptx", grid),
          folder.write("ascii.ply", plyOf("ascii", "double", text)),
          folder.write(
              "little.ply",
              plyOf("binary_little_endian", "double", binaryOf<double>(places, false))),
          folder.write(
              "big.ply",
              plyOf("binary_big_endian", "double", binaryOf<double>(places, true))),
          folder.write("ascii.pcd", pcdOf("8", "ascii", text)),
          folder.write("binary.pcd",
                       pcdOf("8", "binary", binaryOf<double>(places, false)))};
}

void
expectPlaces(const PointCloudFile& file, const Places& places, const std::string& path)
{
  ASSERT_EQ(file.points().size(), places.size()) << path;
  double farthest = 0;
  const bool is_grid = file.cloud.height > 1; // rows of columns
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t at = is_grid ? i % 50 * 60 + i / 50 : i;
    if (places[i].isZero(0))
      EXPECT_FALSE(file.points()[at].allFinite()) << path;
    else
      farthest = std::max(farthest,
                          (file.points()[at].cast<double>() + file.shift - places[i])
                              .cwiseAbs()
                              .maxCoeff());
  }
  EXPECT_LT(farthest, 2e-4) << path;
}

TEST(CoordinateShift, AllFormatsKeepTheirMillimetres)
{
  const TemporaryFolder folder;
  for (const std::size_t zeros : {0, 1, 1400}) {
    const Places places = slope(corner, zeros);
    for (const std::string& path : filesOf(places, folder)) {
      const PointCloudFile file = loadPointCloud(path);
      EXPECT_EQ(file.shift, Eigen::Vector3d(665000, 5648000, 0)) << path;
      EXPECT_THAT(file.remarks, Contains(HasSubstr("665000, 5648000, 0"))) << path;
      EXPECT_THAT(file.remarks, Not(Contains(HasSubstr("round")))) << path;
      expectPlaces(file, places, path);
      PointCloudFile described;
      const CloudRows rows = loadCloudRows(path, {}, described);
      EXPECT_EQ(rows.copy().data.size(), file.cloud.data.size()) << path;
      EXPECT_EQ(described.shift, file.shift) << path;
    }
  }
}

TEST(CoordinateShift, PointsNearTheOriginStayWhereTheyAre)
{
  const TemporaryFolder folder;
  for (const double far : {0.0, 9000.0, -9000.0})
    for (const std::string& path :
         filesOf(slope(Eigen::Vector3d(far + 0.5, 0.25, 3000)), folder)) {
      const PointCloudFile file = loadPointCloud(path);
      EXPECT_TRUE(file.shift.isZero(0)) << path;
      EXPECT_THAT(file.remarks, IsEmpty()) << path;
    }
}

TEST(CoordinateShift, IsThatOfTheUnitAndAsStated)
{
  const TemporaryFolder folder;
  const Places places = slope(Eigen::Vector3d(20000, 30000, 2500)); // millimetres
  PointCloudReader reader;
  reader.setScale(0.001);
  for (const std::string& path : filesOf(places, folder))
    EXPECT_TRUE(reader.read(path).shift.isZero(0)) << path;
  reader.setShift({20, 29.5, 0});
  reader.setSensorOrigin({21, 30, 2});
  for (const std::string& path : filesOf(places, folder)) {
    const PointCloudFile file = reader.read(path);
    EXPECT_EQ(file.shift, Eigen::Vector3d(20, 29.5, 0)) << path;
    EXPECT_LT((file.points()[0] - Eigen::Vector3f(0, 0.5F, 2.5F)).norm(), 1e-5) << path;
    EXPECT_EQ(file.sensor_origin, Eigen::Vector3f(1, 0.5F, 2)) << path;
  }
  EXPECT_THROW(reader.setShift({0, 0, 1e12}), BadArgumentException);
}

TEST(CoordinateShift, LostDigitsAreTold)
{
  const TemporaryFolder folder;
  const std::string bytes = binaryOf<float>(slope(corner), false);
  for (const std::string& path :
       {folder.write("a.ply", plyOf("binary_little_endian", "float", bytes)),
        folder.write("a.pcd", pcdOf("4", "binary", bytes))}) {
    const PointCloudFile file = loadPointCloud(path);
    EXPECT_EQ(file.shift, Eigen::Vector3d(665000, 5648000, 0));
    EXPECT_THAT(file.remarks, Contains(HasSubstr("were rounded to steps")));
  }
}

TEST(CoordinateShift, GeocentricCoordinatesHaveTheirUpDirection)
{
  const TemporaryFolder folder;
  const Eigen::Vector3d place(3900123.5, 600456.25, 4990789.125);
  for (const std::string& path : filesOf(slope(place), folder)) {
    const PointCloudFile file = loadPointCloud(path);
    EXPECT_EQ(file.shift, Eigen::Vector3d(3900000, 600000, 4990000)) << path;
    ASSERT_TRUE(file.up) << path;
    EXPECT_LT((file.up->cast<double>() - place.normalized()).norm(), 1e-3) << path;
  }
  EXPECT_FALSE(
      loadPointCloud(folder.write("grid.xyz", textOf(slope({500100, 6345000, 20}))))
          .up);
}

TEST(CoordinateShift, PackedPcdAndItsViewpointAreShifted)
{
  const TemporaryFolder folder;
  PCLPointCloud2 cloud;
  std::size_t offset = 0;
  for (const char* name : {"x", "y", "z"}) {
    PCLPointField field;
    field.name = name;
    field.offset = static_cast<uindex_t>(offset);
    field.datatype = PCLPointField::FLOAT64;
    field.count = 1;
    cloud.fields.push_back(field);
    offset += sizeof(double);
  }
  const Places places = slope(corner);
  const std::string bytes = binaryOf<double>(places, false);
  cloud.data.assign(bytes.begin(), bytes.end());
  cloud.point_step = static_cast<uindex_t>(offset);
  cloud.width = static_cast<uindex_t>(places.size());
  cloud.height = 1;
  cloud.row_step = cloud.width * cloud.point_step;
  const std::string path = folder.path("packed.pcd");
  PCDWriter().writeBinaryCompressed(path,
                                    cloud,
                                    Eigen::Vector4f(665300, 5648400, 2, 0),
                                    Eigen::Quaternionf::Identity());
  const PointCloudFile file = loadPointCloud(path);
  EXPECT_EQ(file.shift, Eigen::Vector3d(665000, 5648000, 0));
  expectPlaces(file, places, path);
  EXPECT_EQ(file.sensor_origin, Eigen::Vector3f(300, 400, 2));
}

} // namespace
} // namespace pcl::acmap::test
