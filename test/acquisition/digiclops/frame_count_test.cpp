#include "digiclops/camera_stream.h"
#include "digiclops/frame_count.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace pcl::acmap::test {
namespace {

constexpr double period = 0.05;
constexpr std::uint64_t tick = 50000; // microseconds per frame

/** Frame counts with and without a counter in the frames. */
class FrameCounts : public testing::Test {
protected:
  FrameCounts()
  {
    count_.begin(period);
  }

  std::optional<int>
  counted(std::uint32_t counter, std::uint64_t frame)
  {
    return count_.add(counter, 1000000 + frame * tick);
  }

  std::optional<int>
  timed(double frame)
  {
    return count_.add(std::nullopt, 1000000 + static_cast<std::uint64_t>(frame * tick));
  }

  FrameCount count_;
};

/** Random streams: the count finds every lost frame. */
TEST_F(FrameCounts, CountsAllThatIsLost)
{
  std::mt19937_64 random(1);
  for (int run = 0; run < 200; ++run) {
    count_.begin(period);
    // In every other run the counter overflows.
    const auto first = static_cast<std::uint32_t>(run % 2 ? 0xFFFFFFF0 : random());
    std::uint64_t frame = 0;
    std::uint64_t lost = 0;
    EXPECT_EQ(counted(first, frame), 0);
    for (int i = 0; i < 100; ++i) {
      const std::uint64_t step = random() % 4 ? 1 : 1 + random() % 40;
      frame += step;
      lost += step - 1;
      EXPECT_EQ(counted(first + static_cast<std::uint32_t>(frame), frame),
                static_cast<int>(step - 1));
    }
    EXPECT_EQ(lost, frame - 100);
  }
}

/** A callback that is slow now and then: queued frames arrive together with one stamp,
 * and frames that did not fit into the queue never arrive. */
TEST_F(FrameCounts, CountsWhatDidNotFit)
{
  std::mt19937_64 random(4);
  std::uint64_t frame = 0;
  EXPECT_EQ(counted(10, frame), 0);
  std::uint32_t last = 10;
  for (int i = 0; i < 200; ++i) {
    const std::uint32_t waited = 11;
    const auto slow = static_cast<std::uint32_t>(waited + random() % 200);
    frame += slow;
    for (std::uint32_t k = 0; k < waited; ++k)
      EXPECT_EQ(counted(++last, frame), 0);
    last += slow - waited + 1;
    EXPECT_EQ(counted(last, ++frame), static_cast<int>(slow - waited)) << i;
  }
}

TEST_F(FrameCounts, OddCountersAreDroppedAndTheRightOneGoesOn)
{
  std::mt19937_64 random(2);
  EXPECT_EQ(counted(100, 0), 0);
  for (std::uint64_t frame = 1; frame < 200; ++frame) {
    if (frame % 3 == 0)
      EXPECT_EQ(counted(static_cast<std::uint32_t>(random()) | 0x40000000, frame),
                std::nullopt);
    else
      EXPECT_EQ(counted(100 + static_cast<std::uint32_t>(frame), frame),
                frame % 3 == 1 && frame > 1 ? 1 : 0);
  }
}

TEST_F(FrameCounts, TheSameCounterTwiceIsOdd)
{
  EXPECT_EQ(counted(7, 0), 0);
  EXPECT_EQ(counted(7, 1), std::nullopt);
  EXPECT_EQ(counted(9, 2), 1);
}

TEST_F(FrameCounts, AResetIsBelievedWhenItCountsOn)
{
  EXPECT_EQ(counted(5000, 0), 0);
  EXPECT_EQ(counted(5001, 1), 0);
  EXPECT_EQ(counted(0, 2), std::nullopt);
  EXPECT_EQ(counted(1, 3), 0);
  EXPECT_EQ(counted(2, 4), 0);
  EXPECT_EQ(counted(4, 6), 1);
}

TEST_F(FrameCounts, AnotherStreamKnowsNothingOfTheLast)
{
  EXPECT_EQ(counted(5000, 0), 0);
  count_.begin(period);
  EXPECT_EQ(counted(3, 0), 0);
  EXPECT_EQ(counted(4, 1), 0);
}

TEST_F(FrameCounts, ByTimeGapsAreLost)
{
  std::mt19937_64 random(3);
  EXPECT_EQ(timed(0), 0);
  double frame = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto step = static_cast<int>(random() % 4 ? 1 : 2 + random() % 5);
    frame += step;
    const double jitter = 0.2 * (static_cast<double>(random() % 1000) / 1000 - 0.5);
    EXPECT_EQ(timed(frame + jitter), step - 1) << i;
  }
}

TEST_F(FrameCounts, ByTimeFramesInABunchWereNotLost)
{
  int lost = timed(0).value();
  lost += timed(1).value();
  lost += timed(6).value(); // delayed in the queue
  EXPECT_EQ(lost, 4);
  for (const double frame : {6.01, 6.02, 6.03, 6.04}) // these were delayed too
    lost += timed(frame).value();
  EXPECT_EQ(lost, 0);
  lost += timed(6.05).value(); // further frames do not make the count negative
  EXPECT_EQ(lost, 0);
  lost += timed(9).value();
  EXPECT_EQ(lost, 2);
}

TEST_F(FrameCounts, AClockThatJumpsCountsNoBillions)
{
  EXPECT_EQ(timed(0), 0);
  EXPECT_LE(timed(1e9).value(), 1000000);
  EXPECT_LE(count_.add(std::nullopt, 5).value(), 1); // far back in time
}

TEST_F(FrameCounts, ACounterThatJumpsWithTheClockCountsNoBillions)
{
  constexpr std::uint64_t years = 10000000000;
  EXPECT_EQ(counted(1, 0), 0);
  EXPECT_EQ(counted(0xFFFFFFFF, years), std::nullopt);
  EXPECT_EQ(counted(0, years + 1), 0); // continues from there
}

/** Images whose bytes contain their indices. */
IidcFrame
placesOf(const IidcMode& mode)
{
  IidcFrame frame;
  frame.bytes.resize(mode.bytes());
  std::iota(frame.bytes.begin(), frame.bytes.end(), std::uint8_t{0});
  return frame;
}

TEST(CounterInFrames, IsReadAndCovered)
{
  const IidcMode mode{7, 0, 8, 4, IidcColor::Rgb8, {}};
  IidcFrame frame = placesOf(mode);
  EXPECT_EQ(counterOf(frame), 0x00010203U);
  coverCounter(frame, mode, 1);
  IidcFrame want = placesOf(mode);
  for (std::size_t i = 0; i < 4; ++i)
    want.bytes[i] = want.bytes[i + 24];
  EXPECT_EQ(frame.bytes, want.bytes);
  coverCounter(frame, mode, 2); // with a colour filter
  for (std::size_t i = 0; i < 4; ++i)
    want.bytes[i] = want.bytes[i + 48];
  EXPECT_EQ(frame.bytes, want.bytes);
}

TEST(CounterInFrames, OfImagesTooSmallStays)
{
  for (const int height : {1, 2}) {
    const IidcMode mode{7, 0, 1, height, IidcColor::Rgb8, {}};
    IidcFrame frame = placesOf(mode);
    coverCounter(frame, mode, 1);
    EXPECT_EQ(frame.bytes, placesOf(mode).bytes);
  }
}

} // namespace
} // namespace pcl::acmap::test
