#include "temporary_folder.h"

#include <pcl/core/disparity_image.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/** The values 1.5 and -2: the upper one of two rows. */
const std::string upper_row("\0\0\xc0\x3f\0\0\0\xc0", 8);
const std::string lower_row("\0\0\x80\x7f\0\0\x40\x40", 8); // infinity, 3

void
expectUnread(const std::string& text, const std::string& fault)
{
  const TemporaryFolder folder;
  const std::string path = folder.write("bad.pfm", text);
  EXPECT_THAT([&] { loadPfm(path); },
              testing::ThrowsMessage<InputFileException>(
                  testing::AllOf(HasSubstr(path), HasSubstr(fault))))
      << "was read, but should have failed: " << fault;
}

TEST(DisparityImage, IsWrittenByteByByte)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("small.pfm");
  savePfm(path, {2, 2, {1.5f, -2.0f, nan, 3.0f}});
  EXPECT_EQ(contentOf(path), "Pf\n2 2\n-1.0\n" + lower_row + upper_row);
}

TEST(DisparityImage, SurvivesItsFile)
{
  const TemporaryFolder folder;
  DisparityImage image{7, 5, {}};
  for (int i = 0; i < 35; ++i)
    image.values.push_back(i % 6 == 0 ? nan : std::exp(0.37f * i) - 2.0f);
  savePfm(folder.path("image.pfm"), image);
  const DisparityImage read = loadPfm(folder.path("image.pfm"));
  EXPECT_EQ(read.width, 7);
  EXPECT_EQ(read.height, 5);
  ASSERT_EQ(read.values.size(), image.values.size());
  for (std::size_t i = 0; i < image.values.size(); ++i)
    if (std::isnan(image.values[i]))
      EXPECT_TRUE(std::isnan(read.values[i])) << i;
    else
      EXPECT_EQ(read.values[i], image.values[i]) << i;
}

TEST(DisparityImage, BothByteOrdersAreRead)
{
  const TemporaryFolder folder;
  const std::string big("\x3f\xc0\0\0\x7f\xc0\0\0", 8); // 1.5, NaN
  const DisparityImage read =
      loadPfm(folder.write("big.pfm", "Pf\r\n2 1\r\n1.0\r\n" + big));
  EXPECT_EQ(read.at(0, 0), 1.5f);
  EXPECT_TRUE(std::isnan(read.at(1, 0)));
}

TEST(DisparityImage, UglyFilesAreRefused)
{
  const std::string values = lower_row + upper_row;
  expectUnread("PF\n2 2\n-1.0\n" + values, "three channels");
  expectUnread("P5\n2 2\n255\n" + values, "is no PFM");
  expectUnread("Pf\n2 2\n", "header is not whole");
  expectUnread("Pf\n", "header is not whole");
  expectUnread("Pf\n2 x\n-1.0\n" + values, "'x'");
  expectUnread("Pf\n2\n-1.0\n" + values, "width or height");
  expectUnread("Pf\n0 2\n-1.0\n" + values, "width or height");
  expectUnread("Pf\n-2 2\n-1.0\n" + values, "'-2'");
  expectUnread("Pf\n99999999999999999999 2\n-1.0\n" + values, "width or height");
  expectUnread("Pf\n2147483647 2147483647\n-1.0\n" + values, "2^28");
  expectUnread("Pf\n16384 16384\n-1.0\n" + values, "truncated: 16 bytes");
  expectUnread("Pf\n2 2\n0\n" + values, "scale");
  expectUnread("Pf\n2 2\nnan\n" + values, "scale");
  expectUnread("Pf\n2 2\n-1.0\n" + values.substr(1), "truncated: 15 bytes");
  expectUnread("Pf\n2 2\n-1.0\n" + values + "\n", "goes on: 17 bytes");
  expectUnread("", "empty");
  EXPECT_THROW(loadPfm("/nowhere/disparity.pfm"), InputFileException);
}

TEST(DisparityImage, ImagesThatCannotBeAreNotWritten)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("image.pfm");
  EXPECT_THROW(savePfm(path, {}), BadArgumentException);
  EXPECT_THROW(savePfm(path, {2, 2, {1, 2, 3}}), BadArgumentException);
  EXPECT_THROW(savePfm(path, {-2, -2, {1, 2, 3, 4}}), BadArgumentException);
  EXPECT_THROW(savePfm(folder.path("none/image.pfm"), {1, 1, {1}}),
               OutputFileException);
  EXPECT_EQ(folder.count(), 0);
}

} // namespace
} // namespace pcl::acmap::test
