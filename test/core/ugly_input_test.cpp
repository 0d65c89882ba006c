#include "cloud_values.h"
#include "messages.h"
#include "temporary_folder.h"

#include <pcl/core/point_cloud_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/stat.h>

#include <cstdint>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

/** An invalid file, and a part of the error message. */
struct UglyRefusal {
  const char* name; // of the test
  const char* ending;
  std::string content;
  const char* fault;
};

void
PrintTo(const UglyRefusal& refusal, std::ostream* stream)
{
  *stream << refusal.name;
}

class UglyInput : public testing::TestWithParam<UglyRefusal> {};

TEST_P(UglyInput, isRefusedWithItsFault)
{
  const TemporaryFolder folder;
  const std::string path =
      folder.write(std::string("ugly") + GetParam().ending, GetParam().content);
  EXPECT_THAT([&] { loadPointCloud(path); },
              testing::ThrowsMessage<InputFileException>(
                  testing::AllOf(HasSubstr(path + ": "), HasSubstr(GetParam().fault))));
}

std::string
garbage(std::size_t size)
{
  std::string bytes;
  std::uint32_t state = 1;
  while (bytes.size() < size) {
    state = state * 1664525U + 1013904223U;
    bytes += static_cast<char>(state >> 24);
  }
  return bytes;
}

/** A PCD of 12-byte points with these counts in its header. */
std::string
pcd(const std::string& counts, const std::string& encoding, const std::string& data)
{
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 "
         "1\n" +
         counts + "\nDATA " + encoding + "\n" + data;
}

std::string
pcdFields(const std::string& fields)
{
  return fields + "\nPOINTS 1\nDATA binary\n" + std::string(64, '\1');
}

std::string
ply(const std::string& format, const std::string& elements, const std::string& data)
{
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n" + data;
}

std::string
repeated(const std::string& text, int times)
{
  std::string all;
  for (int i = 0; i < times; ++i)
    all += text;
  return all;
}

std::string
plyVertices(const std::string& count)
{
  return "element vertex " + count +
         "\nproperty float x\nproperty float y\nproperty float z\n";
}

std::string
ptxHeader(int columns, int rows, const std::string& first_row)
{
  return std::to_string(columns) + "\n" + std::to_string(rows) +
         "\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n" + first_row + "\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
}

const std::string compressed = "binary_compressed";
const std::string little = "binary_little_endian";
const std::string faces = "element face 4000000000\nproperty list uchar int corners\n";

const UglyRefusal any_format[] = {
    {"emptyPcd", ".pcd", "", "is empty"},
    {"emptyPly", ".ply", "", "is empty"},
    {"unknownEnding", ".stl", "1 2 3\n", "ending '.stl' is not known"},
    {"noEnding", "", "1 2 3\n", "ending '' is not known"},
    {"garbageLas", ".las", garbage(3000), "no LAS file"},
    {"garbageE57", ".e57", garbage(3000), "no E57 file"},
    {"packedLas", ".laz", garbage(3000), "packed by LASzip"},
    {"garbagePcd", ".pcd", garbage(3000), "is no entry of a PCD header"},
    {"garbagePly", ".ply", garbage(3000), "is not a PLY file"},
    {"garbageObj", ".obj", garbage(3000), "has no vertex"},
    {"garbageXyz", ".xyz", garbage(3000), "no row of three numbers"},
    {"noLineEnd", ".pcd", std::string(600000, '#'), "is too long for a line of text"}};

const UglyRefusal pcd_header[] = {
    {"headerOnlyBegun", ".pcd", "FIELDS x y z\nPOINTS 3\n", "before the DATA line"},
    {"noFields", ".pcd", "POINTS 1\nDATA ascii\n1 2 3\n", "has no FIELDS"},
    {"noCounts",
     ".pcd",
     "FIELDS x y z\nDATA ascii\n1 2 3\n",
     "neither POINTS nor WIDTH"},
    {"fieldFlood", ".pcd", pcdFields("FIELDS" + repeated(" a", 1001)), "1000 fields"},
    {"noZ", ".pcd", pcdFields("FIELDS x y"), "not exactly one field z"},
    {"twoX", ".pcd", pcdFields("FIELDS x y z x"), "not exactly one field x"},
    {"manyX", ".pcd", pcdFields("FIELDS x y z\nCOUNT 2 1 1"), "more than one number"},
    {"fewSizes", ".pcd", pcdFields("FIELDS x y z\nSIZE 4 4"), "3 FIELDS but 2 of SIZE"},
    {"threeByteFloat", ".pcd", pcdFields("FIELDS x y z\nSIZE 3 4 4"), "SIZE 3"},
    {"zeroSize", ".pcd", pcdFields("FIELDS x y z\nSIZE 4 4 0"), "SIZE 0"},
    {"unknownType", ".pcd", pcdFields("FIELDS x y z\nTYPE F F Q"), "TYPE 'Q'"},
    {"negativeSize", ".pcd", pcdFields("FIELDS x y z\nSIZE 4 4 -4"), "SIZE '-4'"},
    {"zeroCount", ".pcd", pcdFields("FIELDS x y z\nCOUNT 1 0 1"), "'y' has COUNT 0"},
    {"negativeCount", ".pcd", pcdFields("FIELDS x y z a\nCOUNT 1 1 1 -4"), "COUNT -4"},
    {"hugeCount", ".pcd", pcdFields("FIELDS x y z a\nCOUNT 1 1 1 9e9"), "COUNT '9e9'"},
    {"hugePoint",
     ".pcd",
     pcdFields("FIELDS x y z a b\nCOUNT 1 1 1 2000000000 2000000000"),
     "puts a field at byte"},
    {"paddingBeforeTheBegin",
     ".pcd",
     pcdFields("FIELDS _ x y z\nCOUNT -9 1 1 1"),
     "at byte -36"},
    {"paddingBehindTheEnd",
     ".pcd",
     pcdFields("FIELDS x y z _\nCOUNT 1 1 1 -1"),
     "points of 8 bytes with fields of 12"},
    {"unknownEncoding", ".pcd", pcd("POINTS 1", "zipped", ""), "'zipped' is not known"},
    {"negativePoints", ".pcd", pcd("POINTS -5", "ascii", ""), "POINTS '-5'"},
    {"negativeWidth", ".pcd", pcd("WIDTH -5", "binary", ""), "WIDTH '-5'"},
    {"countsDisagree",
     ".pcd",
     pcd("WIDTH 3\nHEIGHT 2\nPOINTS 5", "binary", std::string(72, 'a')),
     "claims 5 points and 3 x 2"},
    {"viewpointTooShort", ".pcd", "VIEWPOINT 0 0 0 1\n", "needs 7 numbers"},
    {"countsOverflow",
     ".pcd",
     pcd("WIDTH 8589934592\nHEIGHT 8589934592", "binary", "abc"),
     "claims 8589934592 x 8589934592 points"},
    {"countBeyond64Bits",
     ".pcd",
     pcd("POINTS 99999999999999999999", "binary", ""),
     "is not a count"}};

const UglyRefusal pcd_data[] = {
    {"fourBillionBinary",
     ".pcd",
     pcd("POINTS 4294967295", "binary", std::string(812, 'a')),
     "4294967295 points of 12 bytes, 812 bytes follow"},
    {"fourBillionText",
     ".pcd",
     pcd("POINTS 4294967295", "ascii", "1 2 3\n"),
     "4294967295 points of 3 values, 6 bytes follow"},
    {"fourBillionCompressed",
     ".pcd",
     pcd("POINTS 4294967295", compressed, std::string(100, '\1')),
     "4294967295 points of 12 bytes, the compressed block"},
    {"oneByteShort",
     ".pcd",
     pcd("POINTS 2", "binary", std::string(23, 'a')),
     "2 points of 12 bytes, 23 bytes follow"},
    {"textShort",
     ".pcd",
     pcd("POINTS 3", "ascii", "1.00 2.00 3.00\n4 5 6\n"),
     "claims 3 points, the file has 2"},
    {"rowShort",
     ".pcd",
     pcd("POINTS 2", "ascii", "1.00 2 3\n4 5\n"),
     "line 10: has fewer"},
    {"wordForNumber",
     ".pcd",
     pcd("POINTS 1", "ascii", "1 two 3\n"),
     "line 9: 'two' is no value of field 'y'"},
    {"noBlock", ".pcd", pcd("POINTS 2", compressed, "abc"), "is truncated"},
    {"blockTruncated",
     ".pcd",
     pcd("POINTS 2", compressed, rawBytes(20U) + rawBytes(24U) + "abc"),
     "claims a block of 20 bytes, 3 follow"},
    {"blockTooGood",
     ".pcd",
     pcd("POINTS 100000000",
         compressed,
         rawBytes(100U) + rawBytes(1200000000U) + std::string(100, 'a')),
     "claims that 100 bytes unpack to 1200000000"},
    {"blockDamaged",
     ".pcd",
     pcd("POINTS 2",
         compressed,
         rawBytes(20U) + rawBytes(24U) + std::string(20, '\xff')),
     "compressed block is damaged"}};

const UglyRefusal ply_files[] = {
    {"plyWithoutEnd", ".ply", "ply\nformat ascii 1.0\n", "before the end_header line"},
    {"plyWithoutFormat",
     ".ply",
     "ply\n" + plyVertices("0") + "end_header\n",
     "no format"},
    {"plyFormat", ".ply", ply("binary", plyVertices("0"), ""), "'binary' is not known"},
    {"plyNoVertices",
     ".ply",
     ply("ascii", "element edge 0\n", ""),
     "0 vertex elements"},
    {"plyTwice",
     ".ply",
     ply("ascii", plyVertices("0") + plyVertices("0"), ""),
     "2 vertex elements"},
    {"plyNegative", ".ply", ply("ascii", plyVertices("-3"), ""), "the count '-3'"},
    {"plyType",
     ".ply",
     ply("ascii", "element vertex 1\nproperty quad x\n", ""),
     "'quad' is no type"},
    {"plyFlood",
     ".ply",
     ply("ascii", plyVertices("0") + repeated("property int a\n", 998), ""),
     "line 1004: is one of more than 1000"},
    {"plyPropertyFirst", ".ply", "ply\nproperty float x\n", "before any element"},
    {"plyNoX",
     ".ply",
     ply("ascii", "element vertex 1\nproperty float y\n", "1\n"),
     "not exactly one field x"},
    {"plyFloatLength",
     ".ply",
     ply("ascii", "element vertex 1\nproperty list float int a\n", ""),
     "length of a list is 'float'"},
    {"plyFourBillion",
     ".ply",
     ply(little, plyVertices("4294967295"), std::string(812, 'a')),
     "4294967295 points of 12 bytes, 812 bytes follow"},
    {"plyFourBillionText",
     ".ply",
     ply("ascii", plyVertices("4294967295"), "1 2 3\n"),
     "4294967295 points of 3 values, 6 bytes follow"},
    {"plyTextShort",
     ".ply",
     ply("ascii", plyVertices("3"), "1.00 2.00 3.00\n1 2 3\n"),
     "claims 3 rows of element 'vertex', the file has 2"},
    {"plyRowShort",
     ".ply",
     ply("ascii", plyVertices("1"), "1  2  \n"),
     "has fewer values"},
    {"plyFacesMissing",
     ".ply",
     ply(little, plyVertices("1") + faces, std::string(12, 'a')),
     "4000000000 rows of element 'face', 0 bytes follow"},
    {"plyFaceTruncated",
     ".ply",
     ply(little,
         plyVertices("0") + "element face 1\nproperty list uchar int corners\n",
         "\3abcdefgh"),
     "is truncated"},
    {"plyNegativeLength",
     ".ply",
     ply(little,
         plyVertices("0") + "element face 1\nproperty list char int corners\n",
         "\xff"),
     "'corners' has a negative length"}};

const UglyRefusal text_files[] = {
    {"xyzWithoutRows", ".xyz", "# nothing\n", "no row of three numbers"},
    {"xyzTwoColumns", ".xyz", "1 2 3\n4 5\n", "line 2: has fewer than three numbers"},
    {"xyzWord", ".xyz", "1 2 3\n4 five 6\n", "line 2: 'five' is not a number"},
    {"xyzTwoHeaders", ".xyz", "a b c\nd e f\n1 2 3\n", "2 lines that are no points"},
    {"csvForeignNames", ".csv", "Rechts;Hoch;Hoehe\n1;2;3\n", "--columns x,y,z"},
    {"csvDegrees", ".csv", "lat,lon,h\n51.1,7.2,3\n", "latitude"},
    {"txtThousands", ".txt", "1,234.5 2,345.5 3\n", "without commas"},
    {"txtTwoReadings", ".txt", "1,234 2,345 3,456\n", "decimal points only"},
    {"csvDecimalCommas", ".csv", "0,050,1,500,2,250\n", "decimal commas"},
    {"csvWords", ".csv", "P1,1,2,3\nP2,1,2,4\n", "--columns -,x,y,z"},
    {"txtTwoOrders", ".txt", "3 1.5 2.5 3.5\n7 1.5 2.5 4.5\n", "--columns -,x,y,z"},
    {"txtUtf16", ".txt", std::string("\xff\xfe\x31\0", 4), "UTF-16"},
    {"txtCarriageReturns", ".txt", "1 2 3\r4 5 6\r", "CR alone"},
    {"txtPoses", ".txt", "1305031.5 1.5 2.5 0.5 0 0 0.6 0.8\n", "list of poses"},
    {"ascGrid", ".asc", "ncols 3\nnrows 1\n1 2 3\n", "gdal_translate"},
    {"ptxHeader", ".ptx", "2\n1\n0 0 0\n", "header"},
    {"ptxPose", ".ptx", ptxHeader(1, 1, "2 0 0 0") + "1 2 3 0.5\n", "no rotation"},
    {"ptxColumns", ".ptx", ptxHeader(1, 1, "1 0 0 0") + "1 2 3 4 5\n", "rows of 5"},
    {"ptxWord", ".ptx", ptxHeader(1, 1, "1 0 0 0") + "1 two 3 4\n", "'1 two 3 4'"},
    {"xyzTooLargeNumber", ".xyz", "1 2 3\n1 2 1e999\n", "'1e999' is not a number"},
    {"objWithoutVertices", ".obj", "f 1 2 3\n", "has no vertex"},
    {"objTwoNumbers", ".obj", "v 1 2\n", "line 1: vertex has fewer than three numbers"},
    {"objWord", ".obj", "v 1 2 3\nv 1 b 3\n", "line 2: 'b' is not a number"}};

std::string
nameOf(const testing::TestParamInfo<UglyRefusal>& info)
{
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Any, UglyInput, testing::ValuesIn(any_format), nameOf);
INSTANTIATE_TEST_SUITE_P(PcdHeader, UglyInput, testing::ValuesIn(pcd_header), nameOf);
INSTANTIATE_TEST_SUITE_P(PcdData, UglyInput, testing::ValuesIn(pcd_data), nameOf);
INSTANTIATE_TEST_SUITE_P(Ply, UglyInput, testing::ValuesIn(ply_files), nameOf);
INSTANTIATE_TEST_SUITE_P(Text, UglyInput, testing::ValuesIn(text_files), nameOf);

std::string
faultOf(const std::string& path)
{
  return messageOf<InputFileException>([&] { loadPointCloud(path); });
}

TEST(UglyPath, isRefusedWithItsFault)
{
  const TemporaryFolder folder;
  EXPECT_THAT(faultOf(folder.path("missing.pcd")), HasSubstr("No such file"));
  EXPECT_THAT(faultOf(folder.path("")), HasSubstr("is a folder"));
  EXPECT_THAT(faultOf(""), HasSubstr("No such file"));
  ASSERT_EQ(::mkfifo(folder.path("pipe.pcd").c_str(), 0600), 0);
  EXPECT_THAT(faultOf(folder.path("pipe.pcd")), HasSubstr("not a regular file"));
}

TEST(UglyPath, mayHaveBlanksAndForeignLetters)
{
  const TemporaryFolder folder;
  const std::string path = folder.write("Küche, 2. Stock 点云.xyz", "1 2 3\n");
  EXPECT_EQ(loadPointCloud(path).points().size(), 1U);
}

} // namespace
} // namespace pcl::acmap::test
