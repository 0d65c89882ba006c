#include <pcl/acquisition/random_line_pattern.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace pcl::acmap::test {
namespace {

/** \brief FNV-1a hash. */
std::uint64_t
hashOf(const RgbImage& image)
{
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const std::uint8_t value : image.values)
    hash = (hash ^ value) * 0x100000001b3u;
  return hash;
}

TEST(RandomLinePattern, IsOfItsSeedAndNumberAlone)
{
  RandomLinePattern pattern;
  const RgbImage third = pattern.generate(3);
  EXPECT_EQ(third.width, 1024);
  EXPECT_EQ(third.height, 768);
  ASSERT_EQ(third.values.size(), 3u * 1024 * 768);
  const RgbImage first = pattern.generate(0);
  EXPECT_NE(first.values, third.values);
  EXPECT_EQ(pattern.generate(3).values, third.values);
  EXPECT_EQ(RandomLinePattern().generate(3).values, third.values);
  pattern.setSeed(2);
  EXPECT_NE(pattern.generate(3).values, third.values);
  // patterns of neighbouring seeds and numbers are different
  EXPECT_NE(pattern.generate(0).values, RandomLinePattern().generate(1).values);
}

TEST(RandomLinePattern, HasTheSameBytesOnEveryMachine)
{
  EXPECT_EQ(hashOf(RandomLinePattern().generate(0)), 13256614883628134794u);
}

TEST(RandomLinePattern, CoversHalfOfThePictureBarely)
{
  RandomLinePattern pattern;
  double coverage = 0;
  for (std::uint32_t index = 0; index < 20; ++index) {
    const RgbImage image = pattern.generate(index);
    std::size_t lit = 0;
    for (std::size_t i = 0; i < image.values.size(); i += 3)
      lit += image.values[i] != 0 ? 1 : 0;
    EXPECT_NEAR(pattern.getReport().coverage, lit / (1024.0 * 768), 1e-12);
    coverage += pattern.getReport().coverage / 20;
  }
  EXPECT_NEAR(coverage, 0.46, 0.05);
}

TEST(RandomLinePattern, DrawsAgainWhatRepeatsItself)
{
  RandomLinePattern pattern;
  pattern.setNumberOfLines(60); // about every fifth pattern is redrawn
  int redrawn = 0;
  for (std::uint32_t index = 0; index < 40; ++index) {
    pattern.generate(index);
    const RandomLinePatternReport& report = pattern.getReport();
    redrawn += report.redraws > 0 ? 1 : 0;
    EXPECT_EQ(report.lines, 60);
    EXPECT_LT(report.row_side_lobe, 0.5);
    EXPECT_LT(report.column_side_lobe, 0.5);
    EXPECT_GE(report.worst_row_side_lobe, report.row_side_lobe);
    EXPECT_GE(report.worst_column_side_lobe, report.column_side_lobe);
    EXPECT_TRUE(report.remarks.empty());
  }
  EXPECT_GE(redrawn, 1);
  EXPECT_LE(redrawn, 20);
}

TEST(RandomLinePattern, TakesTheBestWhereNoneIsGood)
{
  RandomLinePattern pattern;
  pattern.setNumberOfLines(1);
  const RgbImage image = pattern.generate(0);
  EXPECT_EQ(image.width, 1024);
  EXPECT_EQ(pattern.getReport().redraws, 16);
  ASSERT_EQ(pattern.getReport().remarks.size(), 1u);
  EXPECT_NE(pattern.getReport().remarks[0].find("pattern 0 repeats itself"),
            std::string::npos);
  pattern.setNumberOfLines(200);
  pattern.generate(0);
  EXPECT_TRUE(pattern.getReport().remarks.empty());
}

TEST(RandomLinePattern, IsGreyOrColoured)
{
  RandomLinePattern pattern;
  const RgbImage colored = pattern.generate(0);
  pattern.setColored(false);
  const RgbImage grey = pattern.generate(0);
  std::size_t differing = 0;
  for (std::size_t i = 0; i < grey.values.size(); i += 3) {
    ASSERT_EQ(grey.values[i], grey.values[i + 1]);
    ASSERT_EQ(grey.values[i], grey.values[i + 2]);
    ASSERT_TRUE(grey.values[i] == 0 || grey.values[i] >= 64);
    differing += colored.values[i] != colored.values[i + 1] ? 1 : 0;
  }
  EXPECT_GT(differing, 250000u);
}

TEST(RandomLinePattern, LinesOffTheRowsLeaveNoRowWithoutContrast)
{
  RandomLinePattern pattern;
  pattern.setMinimumAngle(1.5); // the side lobes of columns would always be too high
  for (std::uint32_t index = 0; index < 5; ++index) {
    pattern.generate(index);
    EXPECT_EQ(pattern.getReport().redraws, 0);
    EXPECT_LT(pattern.getReport().worst_row_side_lobe, 0.5);
    EXPECT_GE(pattern.getReport().column_side_lobe, 0.5);
  }
}

TEST(RandomLinePattern, SettersRefuseNonsenseAndKeepTheirValues)
{
  RandomLinePattern pattern;
  const auto expectRefused = [&](const std::function<void()>& call,
                                 const std::string& word) {
    EXPECT_THAT(call,
                testing::ThrowsMessage<BadArgumentException>(testing::HasSubstr(word)))
        << "accepted: " << word;
  };
  expectRefused([&] { pattern.setSize(15, 768); }, "[16, 8192] px");
  expectRefused([&] { pattern.setSize(1024, 8193); }, "pattern height = 8193");
  expectRefused([&] { pattern.setSize(-1024, 768); }, "pattern width = -1024");
  expectRefused([&] { pattern.setNumberOfLines(0); }, "[1, 10000] lines");
  expectRefused([&] { pattern.setNumberOfLines(10001); }, "10001");
  expectRefused([&] { pattern.setLineWidths(0, 6); }, "[1, 6] px");
  expectRefused([&] { pattern.setLineWidths(4, 3); }, "[1, 3] px");
  expectRefused([&] { pattern.setLineWidths(2, 65); }, "[1, 64] px");
  expectRefused([&] { pattern.setMinimumAngle(-0.1); }, "[0, 1.5] rad");
  expectRefused([&] { pattern.setMinimumAngle(std::nan("")); }, "nan");
  expectRefused([&] { pattern.setDisparityRange(3); }, "[4, 1024] px");
  EXPECT_EQ(pattern.getWidth(), 1024);
  EXPECT_EQ(pattern.getHeight(), 768);
  EXPECT_EQ(pattern.getNumberOfLines(), 200);
  EXPECT_EQ(pattern.getLeastLineWidth(), 2);
  EXPECT_EQ(pattern.getMostLineWidth(), 6);
  EXPECT_EQ(pattern.getMinimumAngle(), 0);
  EXPECT_EQ(pattern.getDisparityRange(), 64);
  EXPECT_TRUE(pattern.getColored());
  EXPECT_EQ(pattern.getSeed(), 1u);
}

TEST(RandomLinePattern, ExtremesWork)
{
  RandomLinePattern pattern;
  pattern.setSize(16, 16);
  pattern.setDisparityRange(1024);
  EXPECT_EQ(pattern.generate(0xffffffffu).values.size(), 3u * 16 * 16);
  pattern.setSize(8192, 16);
  pattern.setNumberOfLines(10000);
  pattern.setLineWidths(64, 64);
  pattern.setDisparityRange(4);
  pattern.setSeed(~std::uint64_t{0});
  EXPECT_EQ(pattern.generate(0).width, 8192);
  EXPECT_EQ(pattern.getReport().coverage, 1.0);
}

} // namespace
} // namespace pcl::acmap::test
