#include "cloud_values.h"
#include "temporary_folder.h"

#include <pcl/core/point_cloud_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

PointCloudFile
loadText(const std::string& text)
{
  const TemporaryFolder folder;
  return loadPointCloud(folder.write("cloud.pcd", text));
}

TEST(PcdDialects, takesAHeaderOfTheLeast)
{
  const PointCloudFile file =
      loadText("COLUMNS x y z\nPOINTS 2\nDATA ascii\n1 2 3\n4 5 6");
  EXPECT_EQ(file.cloud.width, 2U);
  EXPECT_EQ(file.cloud.height, 1U);
  EXPECT_THAT(floatsOf(file.cloud, "z"), ElementsAre(3, 6));
  EXPECT_TRUE(file.remarks.empty());
}

TEST(PcdDialects, takesCarriageReturnsCommentsAndBlankLines)
{
  const PointCloudFile file =
      loadText("# made by hand\r\nVERSION .7\r\n\r\nFIELDS x y z\r\nSIZE 4 4 4\r\n"
               "TYPE F F F\r\nCOUNT 1 1 1\r\nWIDTH 1\r\nHEIGHT 2\r\n# more\r\n"
               "POINTS 2\r\nDATA ascii\r\n\r\n1\t2 3\r\n\r\n4 5   6\r\n\r\n");
  EXPECT_EQ(file.cloud.height, 2U);
  EXPECT_THAT(floatsOf(file.cloud, "x"), ElementsAre(1, 4));
  EXPECT_TRUE(file.remarks.empty());
}

TEST(PcdDialects, readsEveryWayToWriteANumber)
{
  const PointCloudFile file =
      loadText("FIELDS x y z label\nSIZE 4 4 4 2\nTYPE F F F U\nPOINTS 4\nDATA ascii\n"
               "nan -NaN 1.#QNAN 7\n+1.5 -.5e1 1e-50 12.0\ninf -inf -1.#INF nan\n1 1 "
               "1e39 1e3\n");
  const auto x = floatsOf(file.cloud, "x");
  const auto y = floatsOf(file.cloud, "y");
  const auto z = floatsOf(file.cloud, "z");
  EXPECT_TRUE(std::isnan(x[0]) && std::isnan(y[0]) && std::isnan(z[0]));
  EXPECT_EQ(x[1], 1.5F);
  EXPECT_EQ(y[1], -5.0F);
  EXPECT_EQ(z[1], 0.0F);
  EXPECT_EQ(x[2], INFINITY);
  EXPECT_EQ(y[2], -INFINITY);
  EXPECT_EQ(z[2], -INFINITY);
  EXPECT_EQ(z[3], INFINITY);
  EXPECT_THAT(bytesOf(file.cloud, "label"), ElementsAre(7, 0, 12, 0, 0, 0, 0xe8, 3));
  EXPECT_EQ(file.cloud.is_dense, 0);
}

TEST(PcdDialects, bringsCoordinatesTogether)
{
  const PointCloudFile file = loadText(
      "FIELDS z intensity x _ y\nSIZE 8 4 2 1 4\nTYPE F F I U F\nCOUNT 1 1 1 3 1\n"
      "POINTS 2\nDATA binary\n" +
      rawBytes(3.0) + rawBytes(0.5F) + rawBytes(std::int16_t{-1}) + "pad" +
      rawBytes(2.0F) + rawBytes(6.0) + rawBytes(0.25F) + rawBytes(std::int16_t{4}) +
      "pad" + rawBytes(5.0F));
  EXPECT_THAT(namesOf(file.cloud), ElementsAre("x", "y", "z", "intensity"));
  EXPECT_EQ(file.points()[0], Eigen::Vector3f(-1, 2, 3));
  EXPECT_EQ(file.points()[1], Eigen::Vector3f(4, 5, 6));
  EXPECT_THAT(floatsOf(file.cloud, "intensity"), ElementsAre(0.5F, 0.25F));
}

TEST(PcdDialects, keepsWideFields)
{
  const PointCloudFile file = loadText(
      "FIELDS x y z t n\nSIZE 4 4 4 8 8\nTYPE F F F F U\nPOINTS 1\nDATA ascii\n"
      "1 2 3 1403636579.763555527 18446744073709551615\n");
  double t = 0;
  std::memcpy(&t, bytesOf(file.cloud, "t").data(), sizeof(t));
  EXPECT_EQ(t, 1403636579.763555527);
  EXPECT_EQ(bytesOf(file.cloud, "n"), std::vector<std::uint8_t>(8, 255));
}

TEST(PcdDialects, takesAnHonestEmptyCloud)
{
  for (const char* encoding : {"ascii", "binary", "binary_compressed"}) {
    const PointCloudFile file =
        loadText(std::string("FIELDS x y z\nWIDTH 0\nHEIGHT 1\nPOINTS 0\nDATA ") +
                 encoding + "\n");
    EXPECT_EQ(file.points().size(), 0U);
    EXPECT_EQ(file.cloud.fields.size(), 3U);
  }
}

TEST(PcdDialects, remarksOnWhatItLeavesOut)
{
  const std::string header = "FIELDS x y z\nPOINTS 1\n";
  EXPECT_THAT(loadText(header + "DATA ascii\n1 2 3\n4 5 6\n").remarks,
              ElementsAre(HasSubstr("goes on after the points")));
  EXPECT_THAT(loadText(header + "DATA ascii\n1 2 3 4\n").remarks,
              ElementsAre(HasSubstr("more values than the header names")));
  EXPECT_THAT(loadText(header + "DATA binary\n" + std::string(24, 'a')).remarks,
              ElementsAre(HasSubstr("goes on after the points")));
  const PointCloudFile turned =
      loadText("VIEWPOINT 1 2 3 0 0 0 0\n" + header + "DATA ascii\n1 2 3\n");
  EXPECT_THAT(turned.remarks, ElementsAre(HasSubstr("not a pose")));
  EXPECT_EQ(turned.sensor_origin, Eigen::Vector3f::Zero());
}

TEST(PcdDialects, remarksOnCoordinatesTooFarApartForFloat)
{
  const std::string header =
      "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nPOINTS 3\nDATA ascii\n1 2 3\n4 5 6\n";
  EXPECT_TRUE(loadText(header + "9000.5 0 nan\n").remarks.empty());
  EXPECT_THAT(loadText(header + "0 -632841.123 12\n").remarks,
              ElementsAre(HasSubstr("632841 m; float32 rounds them to 0.0625 m")));
}

} // namespace
} // namespace pcl::acmap::test
