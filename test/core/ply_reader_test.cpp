#include "cloud_values.h"
#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

PointCloudFile
loadPly(const std::string& text)
{
  const TemporaryFolder folder;
  return loadPointCloud(folder.write("cloud.PLY", text));
}

template <typename Value>
std::string
bigEndian(Value value)
{
  std::string bytes = rawBytes(value);
  std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

TEST(PlyReader, readsWhatPclWrites)
{
  PointCloud<PointXYZRGBNormal> cloud(9, 1);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cloud[i].getVector3fMap() = Eigen::Vector3f(0.5F, -0.25F, 0.125F) * float(i);
    cloud[i].getNormalVector3fMap() = Eigen::Vector3f::UnitX();
    cloud[i].r = static_cast<std::uint8_t>(20 * i);
    cloud[i].g = 7;
    cloud[i].b = 255;
    cloud[i].a = 0; // PLY files do not store alpha for this type
  }
  PCLPointCloud2 blob;
  toPCLPointCloud2(cloud, blob);
  const TemporaryFolder folder;
  const std::string path = folder.path("cloud.ply");
  for (const bool binary : {false, true}) {
    PLYWriter().write(path,
                      blob,
                      Eigen::Vector4f::Zero(),
                      Eigen::Quaternionf::Identity(),
                      binary,
                      false);
    const PointCloudFile file = loadPointCloud(path);
    for (const char* name : {"x", "y", "z", "normal_x", "normal_y", "normal_z", "rgb"})
      EXPECT_EQ(bytesOf(file.cloud, name), bytesOf(blob, name)) << name;
    EXPECT_EQ(floatsOf(file.cloud, "curvature"), floatsOf(blob, "curvature"));
  }
}

const std::string vertex_between_others = "element camera 1\n"
                                          "property float angle\n"
                                          "property list uchar short row\n"
                                          "element vertex 2\n"
                                          "property double x\n"
                                          "property list int uchar seen_by\n"
                                          "property float y\n"
                                          "property ushort quality\n"
                                          "property float z\n"
                                          "property uchar red\n"
                                          "property uchar green\n"
                                          "property uchar blue\n"
                                          "property uchar alpha\n"
                                          "element face 1\n"
                                          "property list uchar int vertex_indices\n"
                                          "end_header\n";

void
expectTwoVertices(const PointCloudFile& file)
{
  EXPECT_THAT(namesOf(file.cloud), ElementsAre("x", "y", "z", "rgba", "quality"));
  ASSERT_EQ(file.points().size(), 2U);
  EXPECT_EQ(file.points()[0], Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(file.points()[1], Eigen::Vector3f(4, 5, 6));
  EXPECT_THAT(bytesOf(file.cloud, "quality"), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(bytesOf(file.cloud, "rgba"), ElementsAre(12, 11, 10, 13, 22, 21, 20, 23));
}

TEST(PlyReader, findsVerticesBetweenOtherElementsInText)
{
  expectTwoVertices(loadPly("ply\r\nformat ascii 1.0\r\ncomment of mine\r\n" +
                            vertex_between_others +
                            "0.5 3 1 2 3\n1 0 2 513 3 10 11 12 13\n"
                            "4 2 9 9 5 1027 6 20 21 22 23\n3 0 1 1\n"));
}

template <typename Store>
std::string
binaryRows(const Store& store)
{
  return store(0.5F) + store(std::uint8_t{2}) + store(std::int16_t{1}) +
         store(std::int16_t{2}) + store(1.0) + store(std::int32_t{0}) + store(2.0F) +
         store(std::uint16_t{513}) + store(3.0F) + "\x0a\x0b\x0c\x0d" + store(4.0) +
         store(std::int32_t{3}) + "abc" + store(5.0F) + store(std::uint16_t{1027}) +
         store(6.0F) + "\x14\x15\x16\x17" + store(std::uint8_t{1}) +
         store(std::int32_t{0});
}

TEST(PlyReader, findsVerticesBetweenOtherElementsInBothBinaryOrders)
{
  expectTwoVertices(loadPly("ply\nformat binary_little_endian 1.0\n" +
                            vertex_between_others +
                            binaryRows([](auto value) { return rawBytes(value); })));
  expectTwoVertices(loadPly("ply\nformat binary_big_endian 1.0\n" +
                            vertex_between_others +
                            binaryRows([](auto value) { return bigEndian(value); })));
}

TEST(PlyReader, readsEveryTypeOfBothBinaryOrders)
{
  const std::string properties =
      "element vertex 1\nproperty float32 x\nproperty float y\nproperty float z\n"
      "property int8 a\nproperty char b\nproperty uint16 c\nproperty int d\n"
      "property uint32 e\nproperty float64 f\nproperty short g\nend_header\n";
  const auto rows = [](auto store) {
    return store(1.0F) + store(2.0F) + store(3.0F) + store(std::int8_t{-5}) +
           store(std::int8_t{6}) + store(std::uint16_t{60000}) +
           store(std::int32_t{-70000}) + store(std::uint32_t{4000000000U}) +
           store(0.125) + store(std::int16_t{-300});
  };
  const PCLPointCloud2 little =
      loadPly("ply\nformat binary_little_endian 1.0\n" + properties +
              rows([](auto value) { return rawBytes(value); }))
          .cloud;
  const PCLPointCloud2 big =
      loadPly("ply\nformat binary_big_endian 1.0\n" + properties +
              rows([](auto value) { return bigEndian(value); }))
          .cloud;
  const PCLPointCloud2 text = loadPly("ply\nformat ascii 1.0\n" + properties +
                                      "1 2 3 -5 6 60000 -70000 4000000000 0.125 -300")
                                  .cloud;
  EXPECT_THAT(floatsOf(little, "z"), ElementsAre(3));
  expectEqual(big, little);
  expectEqual(text, little);
}

/** Rows of many more bytes than the buffer of a file, with colour, and faces. */
template <typename Store>
std::string
manyRows(const std::string& format, const Store& store, float last_x)
{
  constexpr std::uint32_t count = 70000;
  std::string text = "ply\nformat " + format +
                     " 1.0\nelement vertex 70000\n"
                     "property double x\nproperty float y\nproperty float z\n"
                     "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                     "property uint number\nelement face 70000\n"
                     "property list uchar int vertex_indices\nend_header\n";
  for (std::uint32_t i = 0; i < count; ++i)
    text += store(i + 1 == count ? double(last_x) : 0.5 * i) + store(float(i)) +
            store(-1.0F) + store(std::uint8_t(i)) + store(std::uint8_t(i / 256)) +
            store(std::uint8_t{3}) + store(i);
  for (std::int32_t i = 0; i < std::int32_t(count); ++i)
    text += store(std::uint8_t{3}) + store(i) + store(i) + store(i);
  return text;
}

TEST(PlyReader, readsMoreThanTheBufferHolds)
{
  const auto little = [](auto value) { return rawBytes(value); };
  const auto big = [](auto value) { return bigEndian(value); };
  const std::string text = manyRows("binary_little_endian", little, 1.0F);
  const PCLPointCloud2 cloud = loadPly(text).cloud;
  EXPECT_THAT(namesOf(cloud), ElementsAre("x", "y", "z", "rgb", "number"));
  const auto x = floatsOf(cloud, "x");
  const auto y = floatsOf(cloud, "y");
  const auto colour = bytesOf(cloud, "rgb");
  ASSERT_EQ(y.size(), 70000U);
  for (std::uint32_t i = 0; i + 1 < y.size(); ++i) {
    ASSERT_EQ(x[i], 0.5F * float(i));
    ASSERT_EQ(y[i], float(i));
    ASSERT_EQ(colour[4 * i], 3);
    ASSERT_EQ(colour[4 * i + 1], i / 256 % 256);
    ASSERT_EQ(colour[4 * i + 2], i % 256);
    ASSERT_EQ(colour[4 * i + 3], 0);
  }
  EXPECT_TRUE(cloud.is_dense);
  expectEqual(loadPly(manyRows("binary_big_endian", big, 1.0F)).cloud, cloud);
  EXPECT_THROW(loadPly(text.substr(0, text.size() - 1)), InputFileException);
}

TEST(PlyReader, seesTheLastPointThatIsNotFinite)
{
  const auto little = [](auto value) { return rawBytes(value); };
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(),
                          std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()})
    EXPECT_FALSE(loadPly(manyRows("binary_little_endian", little, bad)).cloud.is_dense);
}

TEST(PlyReader, takesAnHonestEmptyCloud)
{
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const PointCloudFile file =
        loadPly(std::string("ply\nformat ") + format +
                " 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
                "property float z\nelement face 0\n"
                "property list uchar int vertex_indices\nend_header\n");
    EXPECT_EQ(file.points().size(), 0U);
    EXPECT_EQ(file.cloud.fields.size(), 3U);
  }
}

TEST(PlyReader, remarksOnCoordinatesTooFarApartForFloat)
{
  EXPECT_THAT(loadPly("ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n"
                      "property double y\nproperty double z\nend_header\n"
                      "0 5100000.25 0\n0 1 0\n0 2 0\n")
                  .remarks,
              ElementsAre(HasSubstr("rounds them to 0.5 m")));
}

std::string
verticesOf(const std::string& properties, const std::string& rows)
{
  return "ply\nformat ascii 1.0\nelement vertex 2\n" + properties + "end_header\n" +
         rows;
}

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";

TEST(PlyReader, takesColoursOfAllNamesAndRanges)
{
  const auto colours =
      [](const std::string& type, const char* names, const char* rows) {
        std::string properties = xyz;
        std::istringstream words(names);
        for (std::string name; words >> name;)
          properties += "property " + type + " " + name + "\n";
        const auto cloud = loadPly(verticesOf(properties, rows)).cloud;
        EXPECT_THAT(namesOf(cloud), ElementsAre("x", "y", "z", "rgb")) << names;
        return bytesOf(cloud, "rgb");
      };
  const auto expected = ElementsAre(0, 128, 255, 0, 51, 0, 0, 0);
  EXPECT_THAT(colours("uint8_t", "R G B", "1 2 3 255 128 0\n4 5 6 0 0 51\n"), expected);
  EXPECT_THAT(colours("uchar",
                      "diffuse_red diffuse_green diffuse_blue",
                      "1 2 3 255 128 0\n4 5 6 0 0 51\n"),
              expected);
  EXPECT_THAT(colours("float", "red green blue", "1 2 3 1 0.5 0\n4 5 6 0 0 0.2\n"),
              expected);
  EXPECT_THAT(colours("double", "r g b", "1 2 3 255 128 0\n4 5 6 0 0 51\n"), expected);
  EXPECT_THAT(
      colours("ushort", "red green blue", "1 2 3 65535 32896 0\n4 5 6 0 0 13107\n"),
      expected);
}

TEST(PlyReader, readsRowsThatAreBrokenIntoLines)
{
  const std::string bytes =
      "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  const auto file = loadPly(verticesOf(xyz + bytes, "1 2 3 \n9 8 7 \n4 5\n6\n1 2 3\n"));
  EXPECT_EQ(file.points()[1], Eigen::Vector3f(4, 5, 6));
  EXPECT_THAT(bytesOf(file.cloud, "rgb"), ElementsAre(7, 8, 9, 0, 3, 2, 1, 0));
  EXPECT_THROW(loadPly(verticesOf(xyz, "1 2\n4 5 6\n7 8 9\n")), InputFileException);
}

TEST(PlyReader, readsCapitalsAndFlags)
{
  const auto file = loadPly(verticesOf(
      "property float X\nproperty float Y\nproperty bool seen\nproperty float Z\n",
      "1 2 1 3\n4 5 0 6\n"));
  EXPECT_EQ(file.points()[1], Eigen::Vector3f(4, 5, 6));
  EXPECT_THAT(bytesOf(file.cloud, "seen"), ElementsAre(1, 0));
}

TEST(PlyReader, TellsGaussianSplats)
{
  const TemporaryFolder folder;
  std::string header = "ply\nformat ascii 1.0\nelement vertex 1\n", row;
  for (const char* name :
       {"x", "y", "z", "f_dc_0", "f_dc_1", "f_dc_2", "opacity", "scale_0", "rot_0"}) {
    header += "property float " + std::string(name) + "\n";
    row += "1 ";
  }
  const PointCloudFile file =
      loadPointCloud(folder.write("splats.ply", header + "end_header\n" + row + "\n"));
  EXPECT_THAT(file.remarks,
              testing::ElementsAre(testing::HasSubstr("Gaussian splats")));
}

} // namespace
} // namespace pcl::acmap::test
