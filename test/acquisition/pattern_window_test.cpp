#include "messages.h"
#include "screen.h"
#include "virtual_display.h"

#include <pcl/acquisition/pattern_window.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace pcl::acmap::test {
namespace {

/** An image in which neighbouring pixels have different colours. */
RgbImage
noise(int width, int height, std::uint64_t seed)
{
  Random random(seed);
  RgbImage image{width, height, {}};
  for (int i = 0; i < 3 * width * height; ++i)
    image.values.push_back(static_cast<std::uint8_t>(random.bits() >> 56));
  return image;
}

/** Number of pixels in which the screen differs from an image at (x, y). */
int
differencesAt(const RgbImage& screen, const RgbImage& image, int x, int y)
{
  int differences = 0;
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      for (int channel = 0; channel < 3; ++channel)
        if (screen.at(x + column, y + row)[channel] != image.at(column, row)[channel]) {
          ++differences;
          break;
        }
  return differences;
}

RgbImage
black(int width, int height)
{
  return {width, height, std::vector<std::uint8_t>(3u * width * height)};
}

template <typename Exception, typename Call>
std::string
refusal(const Call& call)
{
  return messageOf<Exception>(call);
}

class ShownPattern : public testing::Test {
protected:
  void
  SetUp() override
  {
    if (!display_.exists())
      GTEST_SKIP() << "Xvfb is not installed";
  }

  VirtualDisplay display_{"320x240x24"};
};

TEST_F(ShownPattern, ShowsEveryPixelOfAnImageOfItsSize)
{
  PatternWindow window(0);
  EXPECT_EQ(window.getMonitor().width, 320);
  EXPECT_EQ(window.getMonitor().height, 240);
  for (const std::uint64_t seed : {1, 2}) {
    const RgbImage image = noise(320, 240, seed);
    window.show(image);
    EXPECT_EQ(differencesAt(shootScreen(), image, 0, 0), 0);
  }
  window.showNothing();
  EXPECT_EQ(differencesAt(shootScreen(), black(320, 240), 0, 0), 0);
}

TEST_F(ShownPattern, OpensBlackOverWhatIsThere)
{
  PatternWindow below(0);
  below.show(noise(320, 240, 1));
  const PatternWindow above(0);
  EXPECT_EQ(differencesAt(shootScreen(), black(320, 240), 0, 0), 0);
}

TEST_F(ShownPattern, ComesToTheTopAndBackWithoutHelpOfItsOwner)
{
  const RgbImage first = noise(320, 240, 1);
  const RgbImage second = noise(320, 240, 2);
  PatternWindow below(0);
  below.show(first);
  {
    PatternWindow above(0);
    above.show(second);
    EXPECT_EQ(differencesAt(shootScreen(), second, 0, 0), 0);
    below.show(first);
    EXPECT_EQ(differencesAt(shootScreen(), first, 0, 0), 0);
    above.show(second);
  }
  // the server redraws what the other window covered
  EXPECT_EQ(differencesAt(shootScreen(), first, 0, 0), 0);
}

TEST_F(ShownPattern, ScalesOtherSizesWithoutMixingPixels)
{
  PatternWindow window(0);
  const RgbImage small = noise(160, 120, 3);
  window.show(small);
  const RgbImage screen = shootScreen();
  int differences = 0;
  for (int row = 0; row < 240; ++row)
    for (int column = 0; column < 320; ++column)
      differences += std::equal(screen.at(column, row),
                                screen.at(column, row) + 3,
                                small.at(column / 2, row / 2))
                         ? 0
                         : 1;
  EXPECT_EQ(differences, 0);
  // a narrow image: full height, centred, black on both sides
  const RgbImage narrow = noise(100, 240, 4);
  window.show(narrow);
  const RgbImage again = shootScreen();
  EXPECT_EQ(differencesAt(again, narrow, 110, 0), 0);
  EXPECT_EQ(differencesAt(again, black(110, 240), 0, 0), 0);
  EXPECT_EQ(differencesAt(again, black(110, 240), 210, 0), 0);
}

TEST_F(ShownPattern, CoversItsOwnMonitorOnly)
{
  divideScreen({{"left", 0, 0, 120, 240, false}, {"right", 120, 40, 200, 150, true}});
  const std::vector<MonitorPlace> places = PatternWindow::monitors();
  ASSERT_EQ(places.size(), 2u);
  const std::size_t right = places[0].name == "right" ? 0 : 1;
  EXPECT_EQ(places[right].name, "right");
  EXPECT_EQ(places[right].x, 120);
  EXPECT_EQ(places[right].y, 40);
  EXPECT_EQ(places[right].width, 200);
  EXPECT_EQ(places[right].height, 150);
  EXPECT_TRUE(places[right].is_primary);
  EXPECT_EQ(places[1 - right].name, "left");
  EXPECT_FALSE(places[1 - right].is_primary);

  const RgbImage before = shootScreen();
  const RgbImage pattern = noise(200, 150, 5);
  {
    PatternWindow window(right);
    window.show(pattern);
    const RgbImage screen = shootScreen();
    EXPECT_EQ(differencesAt(screen, pattern, 120, 40), 0);
    EXPECT_EQ(differencesAt(screen, before, 0, 0),
              differencesAt(pattern, black(200, 150), 0, 0));
    PatternWindow other(1 - right);
    other.show(noise(120, 240, 6));
    const RgbImage both = shootScreen();
    EXPECT_EQ(differencesAt(both, noise(120, 240, 6), 0, 0), 0);
    EXPECT_EQ(differencesAt(both, pattern, 120, 40), 0);
  }
  EXPECT_EQ(shootScreen().values, before.values);
}

TEST_F(ShownPattern, RefusesMonitorsAndImagesThatAreNot)
{
  const std::string message =
      refusal<BadArgumentException>([] { PatternWindow window(1); });
  EXPECT_NE(message.find("monitor = 1"), std::string::npos) << message;
  EXPECT_NE(message.find("display has 1"), std::string::npos) << message;
  PatternWindow window(0);
  const RgbImage image = noise(320, 240, 1);
  window.show(image);
  RgbImage short_image = image;
  short_image.values.pop_back();
  EXPECT_THROW(window.show({}), BadArgumentException);
  EXPECT_THROW(window.show(short_image), BadArgumentException);
  EXPECT_THROW(window.show({-4, -4, std::vector<std::uint8_t>(48)}),
               BadArgumentException);
  EXPECT_EQ(differencesAt(shootScreen(), image, 0, 0), 0);
}

TEST_F(ShownPattern, WhatTheServerRefusesIsAnException)
{
  divideScreen({{"too wide", 0, 0, 40000, 10, true}}); // pixmaps are limited to 32767
  PatternWindow window(0);
  const std::string message =
      refusal<IOException>([&] { window.show(noise(40, 10, 1)); });
  EXPECT_NE(message.find("showing the pattern failed: BadAlloc"), std::string::npos)
      << message;
  window.showNothing();
  EXPECT_EQ(differencesAt(shootScreen(), black(320, 10), 0, 0), 0);
}

TEST_F(ShownPattern, ALostServerIsAnExceptionAndNotTheEnd)
{
  PatternWindow window(0);
  window.show(noise(320, 240, 1));
  display_.stop();
  for (int i = 0; i < 2; ++i) {
    const std::string message =
        refusal<IOException>([&] { window.show(noise(320, 240, 2)); });
    EXPECT_NE(message.find("is gone"), std::string::npos) << message;
  }
  EXPECT_THROW(window.showNothing(), IOException);
}

TEST(WindowElsewhere, DisplaysThatAreNotAreNamed)
{
  const std::string message =
      refusal<IOException>([] { PatternWindow window(0, ":98765"); });
  EXPECT_NE(message.find(":98765"), std::string::npos) << message;
  EXPECT_THROW(PatternWindow::monitors("nonsense"), IOException);
}

TEST(WindowElsewhere, OtherDepthsAreRefusedByName)
{
  for (const std::string depth : {"8", "16", "30"}) {
    const VirtualDisplay display("320x240x" + depth);
    if (!display.exists())
      GTEST_SKIP() << "no Xvfb of depth " << depth;
    const std::string message = refusal<IOException>([] { PatternWindow window(0); });
    EXPECT_NE(message.find("depth " + depth), std::string::npos) << message;
  }
}

} // namespace
} // namespace pcl::acmap::test
