#include "temporary_folder.h"
#include "tool_cases.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

/** \brief Checks that the tools refuse a file as unreadable, and write nothing. */
void
expectUnreadable(const TemporaryFolder& folder, const std::string& input)
{
  SCOPED_TRACE(input);
  const auto before = folder.count();
  expectRefused(runSurface({input, folder.path("out.ply")}), 3, input);
  expectRefused(runPlanes({input, folder.path("out.json")}), 3, input);
  expectRefused(runViewer({input, "--screenshot", folder.path("out.png")}), 3, input);
  EXPECT_EQ(folder.count(), before);
}

std::string
pcdHeader(const std::string& points, const std::string& encoding)
{
  return "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " +
         points + "\nHEIGHT 1\nPOINTS " + points + "\nDATA " + encoding + "\n";
}

std::string
plyHeader(const std::string& vertices,
          const std::string& faces,
          const std::string& format)
{
  return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         faces + "\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string
garbage(std::size_t size)
{
  Random random(1);
  std::string bytes(size, ' ');
  for (char& byte : bytes)
    byte = static_cast<char>(random.bits());
  return bytes;
}

TEST(UglyInput, MissingFolderEmpty)
{
  const TemporaryFolder folder;
  for (const char* ending : {".pcd", ".ply", ".obj", ".xyz", ".las"}) {
    expectUnreadable(folder, folder.path(std::string("missing") + ending));
    std::filesystem::create_directory(folder.path(std::string("folder") + ending));
    expectUnreadable(folder, folder.path(std::string("folder") + ending));
    expectUnreadable(folder, folder.write(std::string("empty") + ending, ""));
  }
}

TEST(UglyInput, BinaryGarbageAndUnknownEndings)
{
  const TemporaryFolder folder;
  for (const char* ending : {".pcd", ".ply", ".obj", ".xyz", ".las", ".laz", ""})
    expectUnreadable(folder,
                     folder.write(std::string("garbage") + ending, garbage(9000)));
  expectUnreadable(
      folder, folder.write("tail.ply", plyHeader("9", "9", "ascii") + garbage(9000)));
  expectUnreadable(folder,
                   folder.write("tail.pcd", pcdHeader("9", "ascii") + garbage(9000)));
}

TEST(UglyInput, Truncated)
{
  const TemporaryFolder folder;
  const std::string text = planePcd();
  expectUnreadable(folder, folder.write("half.pcd", text.substr(0, text.size() / 2)));
  expectUnreadable(folder, folder.write("header.pcd", text.substr(0, 60)));
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const std::string header = plyHeader("100", "0", format);
    expectUnreadable(folder, folder.write("half.ply", header + std::string(100, '1')));
    expectUnreadable(folder, folder.write("header.ply", header.substr(0, 70)));
  }
}

TEST(UglyInput, HeadersThatLie)
{
  const TemporaryFolder folder;
  for (const char* count :
       {"4000000000", "18446744073709551615", "-1", "1e9", "x", ""}) {
    for (const char* encoding : {"ascii", "binary", "binary_compressed"})
      expectUnreadable(
          folder,
          folder.write("lie.pcd", pcdHeader(count, encoding) + std::string(100, '\1')));
    for (const char* format : {"ascii", "binary_little_endian"}) {
      expectUnreadable(
          folder,
          folder.write("points.ply",
                       plyHeader(count, "0", format) + std::string(100, '\1')));
      expectUnreadable(
          folder,
          folder.write("faces.ply", plyHeader("1", count, format) + "0 0 0\n    "));
    }
  }
}

} // namespace
} // namespace pcl::acmap::test
