#include <pcl/core/progress_bar.h>
#include <pcl/core/time_left.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <utility>

namespace pcl::acmap {
namespace {

constexpr std::size_t wide = 80;

TEST(ProgressBar, TellsShareStepAndTimeLeft)
{
  EXPECT_EQ(progressLine(0.5, "walls", 30, wide),
            "[###############...............] 50 % walls, 30 s left");
  EXPECT_EQ(progressLine(0.1, "walls", 270, wide),
            "[###...........................] 10 % walls, 4 min 30 s left");
}

TEST(ProgressBar, GuessesNoTimeFromNothing)
{
  EXPECT_EQ(progressLine(0, "cells", std::nullopt, wide),
            "[..............................] 0 % cells");
}

TEST(ProgressBar, StaysInsideForFractionsThatDoNot)
{
  EXPECT_EQ(progressLine(7, "end", 0, wide),
            "[##############################] 100 % end, 0 s left");
}

TEST(ProgressBar, IsOneLineOfANarrowTerminal)
{
  const std::string line = progressLine(0.5, "reading a file with a long name", 3, 50);
  EXPECT_LT(line.size(), 50U);
  EXPECT_EQ(line.substr(line.size() - 10), ", 3 s left");
}

TEST(ProgressBar, TakesWhatACallbackIsTold)
{
  ProgressBar bar;
  const ProgressCallback callback = bar.callback();
  EXPECT_TRUE(callback(0.5, "walls"));
  EXPECT_TRUE(callback(0.25, "cells")) << "a fraction that falls stops nothing";
  EXPECT_TRUE(callback(2, "end"));
  const RunTimes times = bar.times();
  EXPECT_EQ(times.front(), std::pair(0.0, 0.0));
  EXPECT_NEAR(times[1].first, 0.5, 1e-12);
  EXPECT_EQ(times.back().first, 1);
  EXPECT_FALSE(bar.isDrawn());
  EXPECT_LT(bar.longestSilence().first, 10);
}

TEST(ProgressBar, OfATerminalThatStatesItsWidth)
{
  setenv("COLUMNS", "123", 1);
  EXPECT_EQ(terminalWidth(), 123U);
  setenv("COLUMNS", "3", 1);
  EXPECT_EQ(terminalWidth(), 40U);
  unsetenv("COLUMNS");
  EXPECT_GE(terminalWidth(), 40U);
}

/** A run of three stages, whose told fractions are not those of its time.
 * \param[in] slowness seconds of this run in one of the model
 * \param[in] first fraction before which all was done by an earlier run
 * \return the largest factor by which the told time is wrong, from a quarter to three quarters of
 * the run on */
double
largestError(TimeLeft& left, double slowness, double first = 0)
{
  const auto secondsAt = [&](double fraction) { // 10 s, 60 s and 30 s
    return slowness * (fraction < 0.5   ? 20 * fraction
                       : fraction < 0.6 ? 10 + 600 * (fraction - 0.5)
                                        : 70 + 75 * (fraction - 0.6));
  };
  const double begin = secondsAt(first), all = secondsAt(1) - begin;
  double largest = 1;
  left.tell(first, 0.01);
  for (double fraction = first; fraction < 1; fraction += 0.001) {
    const double now = 0.01 + secondsAt(fraction) - begin;
    left.tell(fraction, now);
    if (now < all / 4 || now > 3 * all / 4)
      continue;
    const double told = left.at(now).value_or(0);
    largest = std::max(largest, std::exp(std::abs(std::log(told / (all - now)))));
  }
  return largest;
}

TEST(TimeLeft, IsThatOfTheLastRunFromTheSecondOneOn)
{
  TimeLeft first;
  EXPECT_GT(largestError(first, 1), 1.5) << "stages that were guessed wrongly";
  for (const double slowness : {1.0, 0.5, 4.0}) {
    TimeLeft second(first.times(100));
    EXPECT_LT(largestError(second, slowness), 1.3) << slowness;
  }
}

TEST(TimeLeft, KnowsStagesThatWereFinishedBefore)
{
  TimeLeft first;
  largestError(first, 1);
  TimeLeft second(first.times(100));
  EXPECT_LT(largestError(second, 1, 0.55), 1.3);
}

TEST(TimeLeft, CountsDownWhileNothingIsTold)
{
  TimeLeft first;
  largestError(first, 1);
  TimeLeft second(first.times(100));
  second.tell(0.5, 10);
  const double told = second.at(10).value_or(0);
  EXPECT_NEAR(second.at(11).value_or(0), told - 1, 0.2);
  EXPECT_GE(second.at(1000).value_or(-1), 0) << "longer than ever";
}

TEST(TimeLeft, IsNotToldFromNothing)
{
  TimeLeft left;
  left.tell(0.01, 20);
  EXPECT_FALSE(left.at(20));
}

} // namespace
} // namespace pcl::acmap
