#include <pcl/core/progress.h>
#include <pcl/core/report.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace pcl::acmap::test {
namespace {

TEST(Progress, tellsItsCallback)
{
  std::vector<std::pair<double, std::string>> told;
  const Progress progress([&](double fraction, const std::string& step) {
    told.emplace_back(fraction, step);
    return true;
  });
  progress.tell(0.25, "wall");
  progress.tell(1.0, "last pass");
  EXPECT_THAT(told,
              testing::ElementsAre(testing::Pair(0.25, "wall"),
                                   testing::Pair(1.0, "last pass")));
}

TEST(Progress, isSilentWithoutCallback)
{
  EXPECT_NO_THROW(Progress().tell(0.5, "wall"));
}

TEST(Progress, turnsARefusalIntoAnException)
{
  const Progress progress([](double, const std::string&) { return false; });
  try {
    progress.tell(0.5, "wall");
    FAIL() << "went on";
  }
  catch (const CancelledException& exception) {
    EXPECT_THAT(exception.what(), testing::HasSubstr("cancelled during wall"));
  }
}

TEST(StepTimer, listsStepsInTheirOrder)
{
  Report report;
  StepTimer timer(report);
  timer.finish("read");
  timer.finish("mesh");
  ASSERT_EQ(report.seconds.size(), 2U);
  EXPECT_EQ(report.seconds[0].first, "read");
  EXPECT_EQ(report.seconds[1].first, "mesh");
  EXPECT_GE(report.seconds[1].second, 0.0);
}

} // namespace
} // namespace pcl::acmap::test
