#include "tool.h"

#include <gtest/gtest.h>

namespace pcl::acmap {
namespace {

TEST(ProgressBar, TellsShareStepAndTimeLeft)
{
  EXPECT_EQ(progressLine(0.5, "walls", 30),
            "[###############...............] 50 % walls, 30 s left");
  EXPECT_EQ(progressLine(0.1, "walls", 30),
            "[###...........................] 10 % walls, 4 min 30 s left");
}

TEST(ProgressBar, GuessesNoTimeFromNothing)
{
  EXPECT_EQ(progressLine(0, "cells", 3), "[..............................] 0 % cells");
}

TEST(ProgressBar, StaysInsideForFractionsThatDoNot)
{
  EXPECT_EQ(progressLine(7, "end", 3),
            "[##############################] 100 % end, 0 s left");
}

} // namespace
} // namespace pcl::acmap
