#include "cloud_values.h"
#include "temporary_folder.h"

#include <pcl/core/point_cloud_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

PointCloudFile
loadText(const std::string& name, const std::string& text)
{
  const TemporaryFolder folder;
  return loadPointCloud(folder.write(name, text));
}

void
expectOneToSix(const PointCloudFile& file)
{
  ASSERT_EQ(file.points().size(), 2U);
  EXPECT_EQ(file.points()[0], Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(file.points()[1], Eigen::Vector3f(4, 5, 6));
}

TEST(XyzReader, takesEverySeparatorAndComment)
{
  const PointCloudFile file =
      loadText("a b.XYZ", "# names\n\n  // more\n1,2;3\r\n4\t 5 , 6 17 red\n");
  expectOneToSix(file);
  EXPECT_EQ(file.cloud.point_step, 12U);
  EXPECT_EQ(file.cloud.is_dense, 1);
  EXPECT_THAT(file.remarks, IsEmpty());
}

TEST(XyzReader, remarksOnLinesAboveTheRows)
{
  const auto names = loadText("a.xyz", "X Y Z\n1 2 3\n4 5 6");
  expectOneToSix(names);
  EXPECT_THAT(names.remarks, ElementsAre(HasSubstr("line of names")));
  const auto count = loadText("a.xyz", "2\n1 2 3\n4 5 6");
  expectOneToSix(count);
  EXPECT_THAT(count.remarks, ElementsAre(HasSubstr("count of the points")));
  const auto wrong = loadText("a.xyz", "7\nx y z\n1 2 3\n4 5 6");
  expectOneToSix(wrong);
  EXPECT_THAT(wrong.remarks,
              ElementsAre(HasSubstr("line of names"),
                          HasSubstr("claims 7 points, the file has 2")));
}

TEST(XyzReader, keepsPointsThatAreNotFinite)
{
  const auto file = loadText("a.xyz", "1 2 nan\n1 2 3\n");
  EXPECT_EQ(file.points().size(), 2U);
  EXPECT_EQ(file.cloud.is_dense, 0);
}

TEST(XyzReader, remarksOnCoordinatesTooLargeForFloat)
{
  EXPECT_THAT(loadText("a.xyz", "1 2 131072.5\n").remarks,
              ElementsAre(HasSubstr("rounds them to 0.015625 m")));
}

TEST(ObjReader, readsVerticesOnly)
{
  const auto file = loadText("mesh.obj",
                             "# a triangle\no thing\nv 1 2 3\nvn 0 0 1\nv\t4 5 6 1.0\n"
                             "vt 0 0\nf 1//1 2//1 1//1\n");
  expectOneToSix(file);
  EXPECT_THAT(namesOf(file.cloud), ElementsAre("x", "y", "z"));
  EXPECT_THAT(file.remarks, IsEmpty());
}

TEST(ObjReader, readsColoursOfBothRanges)
{
  const auto fractions =
      loadText("mesh.obj", "v 1 2 3 1 0.5 0\nv 4 5 6 0 0 0.2\n").cloud;
  EXPECT_THAT(bytesOf(fractions, "rgb"), ElementsAre(0, 128, 255, 0, 51, 0, 0, 0));
  const auto bytes = loadText("mesh.obj", "v 1 2 3 255 1 0\nv 4 5 6 0 0 9\n").cloud;
  EXPECT_THAT(bytesOf(bytes, "rgb"), ElementsAre(0, 1, 255, 0, 9, 0, 0, 0));
}

TEST(ObjReader, survivesColoursThatAreNoNumbers)
{
  const auto cloud = loadText("mesh.obj", "v 1 2 3 nan inf -1\n").cloud;
  EXPECT_EQ(bytesOf(cloud, "rgb").size(), 4U);
}

TEST(ObjReader, leavesColoursOutThatSomeVerticesLack)
{
  const auto file = loadText("mesh.obj", "v 1 2 3 1 0 0\nv 4 5 6\n");
  expectOneToSix(file);
  EXPECT_THAT(namesOf(file.cloud), ElementsAre("x", "y", "z"));
  EXPECT_THAT(file.remarks, ElementsAre(HasSubstr("only some vertices")));
}

} // namespace
} // namespace pcl::acmap::test
