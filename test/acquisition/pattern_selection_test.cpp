#include <pcl/acquisition/pattern_selection.h>
#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace pcl::acmap::test {
namespace {

RandomLinePattern
smallLines()
{
  RandomLinePattern lines;
  lines.setSize(96, 64);
  lines.setNumberOfLines(30);
  return lines;
}

RgbImage
noise(int width, int height, std::uint64_t seed)
{
  Random random(seed);
  RgbImage image{width, height, {}};
  for (int i = 0; i < 3 * width * height; ++i)
    image.values.push_back(static_cast<std::uint8_t>(random.bits() % 256));
  return image;
}

int
greyAt(const RgbImage& image, int x, int y)
{
  const std::uint8_t* const color =
      &image.values[static_cast<std::size_t>(3 * (y * image.width + x))];
  return (77 * color[0] + 150 * color[1] + 29 * color[2]) / 256;
}

/** The contrast of all pairs by its definition. */
double
contrastOf(const std::vector<RgbImage>& patterns, int range, double sufficient)
{
  double all = 0;
  const auto add = [&](int x, int y, int u, int v) {
    double sum = 0;
    for (const RgbImage& pattern : patterns) {
      const double difference = greyAt(pattern, x, y) - greyAt(pattern, u, v);
      sum += difference * difference;
    }
    all += std::min(sum, sufficient * sufficient);
  };
  const int width = patterns[0].width / 4 * 4, height = patterns[0].height / 4 * 4;
  for (int y = 2; y < height; y += 4)
    for (int x = 2; x < width; x += 4)
      for (int shift = 4; shift <= range; shift += 4) {
        if (x + shift < width)
          add(x, y, x + shift, y);
        if (y + shift < height)
          add(x, y, x, y + shift);
      }
  return all;
}

TEST(PatternSelection, GainIsTheAddedContrast)
{
  for (const auto& [width, height] : {std::pair{96, 64}, {33, 18}, {5, 70}, {1, 1}})
    for (const int range : {4, 30, 64})
      for (const double sufficient : {20.0, 150.0}) {
        PatternSelection selection;
        selection.setDisparityRange(range);
        selection.setSufficientContrast(sufficient);
        std::vector<RgbImage> shown;
        double before = 0;
        for (std::uint64_t seed = 0; seed < 4; ++seed) {
          shown.push_back(noise(width, height, seed));
          const double gain = static_cast<double>(selection.gainOf(shown.back()));
          const double after = contrastOf(shown, range, sufficient);
          EXPECT_EQ(gain, after - before) << width << " x " << height;
          selection.add(shown.back());
          before = after;
        }
      }
}

TEST(PatternSelection, EachPatternIsTheBestCandidate)
{
  RandomLinePattern lines = smallLines();
  PatternSelection selection;
  selection.setNumberOfCandidates(5);
  const auto selected = selection.selectFrom(lines, 6);
  ASSERT_EQ(selected.size(), 6u);

  PatternSelection again;
  std::vector<RgbImage> candidates;
  std::uint32_t next = 0;
  for (const RgbImage& one : selected) {
    while (candidates.size() < 5)
      candidates.push_back(lines.generate(next++));
    const std::uint64_t gain = again.gainOf(one);
    for (const RgbImage& candidate : candidates)
      EXPECT_GE(gain, again.gainOf(candidate));
    const auto found = std::find_if(candidates.begin(), candidates.end(), [&](auto& c) {
      return c.values == one.values;
    });
    ASSERT_NE(found, candidates.end()) << "not a candidate, or selected twice";
    candidates.erase(found);
    again.add(one);
  }
}

TEST(PatternSelection, TwoRunsGiveTheSamePatterns)
{
  RandomLinePattern lines = smallLines();
  PatternSelection selection;
  selection.setNumberOfCandidates(8);
  const auto first = selection.selectFrom(lines, 3);
  selection.clear();
  const auto second = selection.selectFrom(lines, 3);
  for (std::size_t i = 0; i < first.size(); ++i)
    EXPECT_EQ(first[i].values, second[i].values);
}

TEST(PatternSelection, PatternsThatWereShownGainNothingOnceTheySuffice)
{
  PatternSelection selection;
  selection.setSufficientContrast(1);
  const RgbImage shown = noise(64, 48, 1);
  selection.add(shown);
  EXPECT_EQ(selection.gainOf(shown), 0u);
  EXPECT_EQ(selection.gainOf({64, 48, std::vector<std::uint8_t>(3 * 64 * 48, 9)}), 0u);
}

TEST(PatternSelection, BadInputIsRefused)
{
  PatternSelection selection;
  selection.setNumberOfCandidates(2);
  EXPECT_THROW(selection.setDisparityRange(3), BadArgumentException);
  EXPECT_THROW(selection.setDisparityRange(1025), BadArgumentException);
  EXPECT_THROW(selection.setSufficientContrast(0.5), BadArgumentException);
  EXPECT_THROW(selection.setNumberOfCandidates(0), BadArgumentException);
  EXPECT_THROW(selection.add({}), BadArgumentException);
  EXPECT_THROW(selection.add({4, 4, std::vector<std::uint8_t>(47)}),
               BadArgumentException);
  selection.add(noise(32, 32, 1));
  EXPECT_THROW(selection.gainOf(noise(32, 16, 1)), BadArgumentException);
  RandomLinePattern lines = smallLines();
  EXPECT_THROW(selection.selectFrom(lines, 1), BadArgumentException);
  selection.clear();
  EXPECT_EQ(selection.selectFrom(lines, 1).size(), 1u);
  EXPECT_TRUE(selection.selectFrom(lines, 0).empty());
}

} // namespace
} // namespace pcl::acmap::test
