#include "cloud_values.h"
#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_cloud_reader.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>

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

TEST(XyzReader, understandsLinesAboveTheRows)
{
  const auto names = loadText("a.xyz", "X Y Z\n1 2 3\n4 5 6");
  expectOneToSix(names);
  EXPECT_THAT(names.remarks, IsEmpty());
  const auto count = loadText("a.xyz", "2\n1 2 3\n4 5 6");
  expectOneToSix(count);
  EXPECT_THAT(count.remarks, ElementsAre(HasSubstr("count of the points")));
  const auto wrong = loadText("a.xyz", "7\nx y z\n1 2 3\n4 5 6");
  expectOneToSix(wrong);
  EXPECT_THAT(wrong.remarks, ElementsAre(HasSubstr("claims 7 points, the file has 2")));
  const auto title = loadText("a.xyz", "the hall, May\n1 2 3 4 5\n4 5 6 4 5");
  expectOneToSix(title);
  EXPECT_THAT(title.remarks, ElementsAre(HasSubstr("line of text")));
}

/** A text, and how its columns are told. */
struct TextColumns {
  const char* text;
  const char* told;
};

TEST(TextReader, NamesDecide)
{
  for (const auto& [text, told] : std::initializer_list<TextColumns>{
           {"id,x,y,z\n7,1,2,3\n9,4,5,6\n", "id (left out), x, y, z"},
           {"\"Z\";\"Y\";\"X\"\n3;2;1\n6;5;4\n", "z, y, x"},
           {"//X Y Z\n1 2 3\n4 5 6\n", "x, y, z"},
           {"# x y z nx ny nz\n1 2 3 0 0 1\n4 5 6 0 0 1\n",
            "x, y, z, normal_x, normal_y, normal_z"},
           {"x [m]\ty [m]\tz [m]\tnote\n1\t2\t3\tred\n4\t5\t6\tblue\n",
            "x, y, z, note (left out)"},
           {"easting,northing,elevation,r,g\n1,2,3,4,5\n4,5,6,7,8\n",
            "x, y, z, r (left out), g (left out)"},
           {"\xef\xbb\xbf"
            "1 2 3\r\n4 5 6\r\n",
            "x, y, z"},
           {"1,0\t2,0\t3,0\n4,0\t5,0\t6,0\n", "x, y, z, with decimal commas"},
           {"Hochwert;Rechtswert;H\xc3\xb6he;Gr\xfcn\n2;1;3;0\n5;4;6;0\n",
            "y, x, z, Gr?n (left out)"},
           {"X;Y;Z;Rouge;Vert;Bleu\n1;2;3;9;9;9\n4;5;6;9;9;9\n",
            "x, y, z, red, green, blue"},
           {"E,N,H\n1,2,3\n4,5,6\n", "x, y, z"},
           {"x,y,z,n,h\n1,2,3,9,9\n4,5,6,9,9\n", "x, y, z, n (left out), h (left out)"},
           {"Easting (m),Northing (m),Ellipsoidal Height (m)\n1,2,3\n4,5,6\n",
            "x, y, z"},
           {"X;Y;Z\nm;m;m\n1;2;3\n4;5;6\n", "x, y, z"},
           {"; of a survey\n% in metres\n1;2;3\n4;5;6\n", "x, y, z"},
           {"1,0;2,0;3\n4,0;5;6,0\n", "x, y, z, with decimal commas"},
           {"1,2,3,\n4,5,6,\n", "x, y, z"},
           {"1|2|3\n4|5|6\n", "x, y, z"},
           {"Nr|X|Y|Z\na 1|1.0|2.0|3.0\nb 1|4.0|5.0|6.0\n", "Nr (left out), x, y, z"},
           {"1 1.0 2.0 3.5\n", "x, y, z, column 4 (left out)"}}) {
    const PointCloudFile file = loadText("a.csv", text);
    EXPECT_EQ(file.columns, told) << text;
    if (file.points().size() == 2)
      expectOneToSix(file);
  }
}

TEST(TextReader, MakesMetresOfTheUnitInNames)
{
  for (const char* text : {"X [mm];Y [mm];Z [mm]\n1000;2000;3000\n4000;5000;6000\n",
                           "x (cm)\ty (cm)\tz (cm)\n100\t200\t300\n400\t500\t600\n",
                           "X,Y,Z\nmm,mm,mm\n1000,2000,3000\n4000,5000,6000\n",
                           "x_mm,y_mm,z_mm\n1000,2000,3000\n4000,5000,6000\n"}) {
    const PointCloudFile file = loadText("a.csv", text);
    expectOneToSix(file);
    EXPECT_THAT(file.remarks, ElementsAre(HasSubstr("--scale"))) << text;
    EXPECT_TRUE(file.stated_scale);
  }
  const TemporaryFolder folder;
  PointCloudReader reader;
  reader.setScale(1);
  expectOneToSix(
      reader.read(folder.write("a.csv", "x [ft],y [ft],z [ft]\n1,2,3\n4,5,6\n")));
  const PointCloudFile feet =
      loadText("a.csv", "E (US ft),N (US ft),H (US ft)\n3937,0,0\n0,3937,0\n");
  EXPECT_FLOAT_EQ(feet.points()[0].x(), 1200);
  const PointCloudFile rods =
      loadText("a.csv", "x (rods),y (rods),z (rods)\n1,2,3\n4,5,6\n");
  expectOneToSix(rods);
  EXPECT_THAT(rods.remarks, testing::Contains(HasSubstr("is in 'rods'")));
  EXPECT_THROW(loadText("a.csv", "x [m],y [m],z [mm]\n1,2,3\n4,5,6\n"),
               InputFileException);
}

TEST(TextReader, ColumnsOfSurveysAreTold)
{
  const PointCloudFile file = loadText("a.txt", "Nr Y X Z\n9 2 1 3\n7 5 4 6\n");
  expectOneToSix(file);
  EXPECT_THAT(file.remarks, ElementsAre(HasSubstr("--columns")));
}

TEST(TextReader, TheLastColumnsMayBeEmpty)
{
  expectOneToSix(loadText("a.csv", "x,y,z,note\n1,2,3,\n4,5,6,\n"));
  EXPECT_THROW(loadText("a.csv", "x,y,note,z\n1,2,3,\n4,5,6,\n"), InputFileException);
}

TEST(TextReader, MarksOfThousandsAreNoSeparators)
{
  for (const char* text :
       {"2'600'123.5;-1'200.25;512.0\n2'600'124.5;1'200;1'512\n",
        "2'600'123.5 -1'200.25 512.0\n2'600'124.5 1'200 1'512\n",
        "2\xe2\x80\x99"
        "600\xe2\x80\x99"
        "123.5\t-1\xe2\x80\x99"
        "200.25\t512\n2600124.5\t1200\t1512\n",
        "2 600 123,5;-1 200,25;512,0\n2 600 124,5;1 200;1 512\n",
        "2\xc2\xa0"
        "600\xc2\xa0"
        "123.5|-1200.25|512\n2600124.5|1200|1512\n",
        "2 600 123.5\t-1 200.25\t512.0\n2600124.5\t1 200\t1512\n",
        "X|Y|Z\n2'600'123,5|-1'200,25|512,0\n2600124,5|1200|1512\n"}) {
    const PointCloudFile file = loadText("a.txt", text);
    ASSERT_EQ(file.points().size(), 2U) << text;
    EXPECT_EQ(file.shift, Eigen::Vector3d(2600000, 0, 0)) << text;
    EXPECT_EQ(file.points()[0], Eigen::Vector3f(123.5F, -1200.25F, 512)) << text;
    EXPECT_EQ(file.points()[1], Eigen::Vector3f(124.5F, 1200, 1512)) << text;
  }
  EXPECT_THROW(loadText("a.txt", "2'60'123 1 2\n3 4 5\n"), InputFileException);
  expectOneToSix(loadText("a.txt", "1 2 3 100 200 300\n4 5 6 100 200 300\n"));
}

std::string
rowsOf(std::size_t count, const std::function<std::string(std::size_t)>& row)
{
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
    text += row(i) + "\n";
  return text;
}

TEST(TextReader, NumbersSayWhatHasNoNames)
{
  const auto told = [](const std::string& rest, const char* name = "a.txt") {
    return loadText(name,
                    rowsOf(30,
                           [&](std::size_t i) {
                             return std::to_string(0.5 + i) + " 2.5 3.5 " + rest;
                           }))
        .columns;
  };
  EXPECT_EQ(told("200 3 9"), "x, y, z, red, green, blue");
  EXPECT_EQ(told("0.25 0.5 0.1"), "x, y, z, red, green, blue");
  EXPECT_EQ(told("0.6 0.8 0.0").find("red"), std::string::npos) << "a normal";
  EXPECT_EQ(told("3 1 2").find("red"), std::string::npos) << "echoes";
  EXPECT_EQ(told("1200 200 3 9"), "x, y, z, column 4 (left out), red, green, blue");
  EXPECT_EQ(told("200 3 9 255"), "x, y, z, red, green, blue, column 7 (left out)");
  EXPECT_EQ(told("100 200 3 9").find("red"), std::string::npos) << "two places";
  EXPECT_EQ(told("100 200 3 9", "a.pts"), "x, y, z, intensity, red, green, blue");
  const auto counted = loadText("a.xyz", rowsOf(30, [](std::size_t i) {
                                  return std::to_string(i + 1) + " 1 2 3";
                                }));
  EXPECT_EQ(counted.columns, "column 1 (left out), x, y, z");
  EXPECT_EQ(counted.points()[4], Eigen::Vector3f(1, 2, 3));
}

TEST(TextReader, ColoursHaveThreeRanges)
{
  for (const char* rows :
       {"1 2 3 1.0 0.5 0.0\n4 5 6 0.0 0.0 0.2\n", "1 2 3 255 128 0\n4 5 6 0 0 51\n"})
    EXPECT_THAT(bytesOf(loadText("a.txt", rows).cloud, "rgb"),
                ElementsAre(0, 128, 255, 0, 51, 0, 0, 0))
        << rows;
  const auto wide =
      loadText("a.txt", "x y z red green blue\n1 2 3 65535 32896 0\n4 5 6 0 0 13107\n");
  EXPECT_THAT(bytesOf(wide.cloud, "rgb"), ElementsAre(0, 128, 255, 0, 51, 0, 0, 0));
  EXPECT_THROW(loadText("a.txt",
                        rowsOf(3000,
                               [](std::size_t i) {
                                 return std::string("1 2 3 ") +
                                        (i < 2999 ? "200" : "4000") + " 1 2";
                               })),
               InputFileException);
}

TEST(TextReader, StatedColumnsHold)
{
  const TemporaryFolder folder;
  PointCloudReader reader;
  reader.setColumns({"-", "z", "y", "x", "-", "i"});
  const PointCloudFile file =
      reader.read(folder.write("a.txt", "a b c d e f\n9 3 2 1 9 0.5\n9 6 5 4 9 1.5\n"));
  expectOneToSix(file);
  EXPECT_EQ(valueOf<float>(file.cloud, "intensity", 1), 1.5F);
  EXPECT_THROW(reader.setColumns({"x", "y"}), BadArgumentException);
  EXPECT_THROW(reader.setColumns({"x", "y", "z", "x"}), BadArgumentException);
  EXPECT_THROW(reader.setColumns({"x", "y", "z", "w"}), BadArgumentException);
  EXPECT_THROW(reader.read(folder.write("a.obj", "v 1 2 3\n")), InputFileException);
}

TEST(PtsReader, BlocksHaveTheirCounts)
{
  const auto file = loadText("a.pts", "1\n1 2 3 -800 255 128 0\n1\n4 5 6 90 0 0 51\n");
  expectOneToSix(file);
  EXPECT_THAT(namesOf(file.cloud), ElementsAre("x", "y", "z", "rgb", "intensity"));
  EXPECT_THAT(file.remarks, IsEmpty());
}

TEST(XyzReader, keepsPointsThatAreNotFinite)
{
  const auto file = loadText("a.xyz", "1 2 nan\n1 2 3\n");
  EXPECT_EQ(file.points().size(), 2U);
  EXPECT_EQ(file.cloud.is_dense, 0);
}

TEST(XyzReader, remarksOnCoordinatesTooFarApartForFloat)
{
  EXPECT_THAT(loadText("a.xyz", "1 2 0.5\n1 2 131072.5\n1 2 1.5\n").remarks,
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
