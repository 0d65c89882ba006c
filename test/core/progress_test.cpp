#include <pcl/core/impl/parallel.h>
#include <pcl/core/progress.h>
#include <pcl/core/report.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>
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

/** Runs a long loop in several threads after a step was told.
 * \return what was told, each in the thread that called this */
std::vector<std::string>
toldInLongLoop(std::size_t allowed, unsigned threads)
{
  std::vector<std::string> told;
  const std::thread::id caller = std::this_thread::get_id();
  const Progress progress([&](double fraction, const std::string& step) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_EQ(fraction, 0.25);
    told.push_back(step);
    return told.size() < allowed;
  });
  withThreads(threads, [&] {
    progress.tell(0.25, "sums");
    constexpr std::size_t chunks = 200; // a second or more
    EXPECT_THROW(parallelForChunks(chunks * parallel_chunk,
                                   [](std::size_t, std::size_t) {
                                     std::this_thread::sleep_for(
                                         std::chrono::milliseconds(20));
                                   }),
                 CancelledException);
  });
  return told;
}

TEST(Progress, isToldAgainInALongLoopWhichItCanStop)
{
  for (const unsigned threads : {1U, 4U})
    EXPECT_THAT(toldInLongLoop(3, threads),
                testing::ElementsAre("sums", "sums", "sums"));
}

TEST(Progress, isNotToldAgainAfterItsEnd)
{
  int calls = 0;
  {
    const Progress progress([&](double, const std::string&) { return ++calls > 0; });
    progress.tell(0.5, "sums");
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(150));
  pollRun();
  EXPECT_EQ(calls, 1);
}

TEST(Progress, mayRunALongLoopItself)
{
  int calls = 0;
  const Progress progress([&](double, const std::string&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    pollRun();
    return ++calls > 0;
  });
  progress.tell(0.5, "sums");
  std::this_thread::sleep_for(std::chrono::milliseconds(150));
  pollRun();
  EXPECT_EQ(calls, 2);
}

TEST(Progress, isSilentWithoutCallback)
{
  EXPECT_NO_THROW(Progress().tell(0.5, "wall"));
}

TEST(Progress, turnsARefusalIntoAnException)
{
  const Progress progress([](double, const std::string&) { return false; });
  EXPECT_THAT([&] { progress.tell(0.5, "wall"); },
              testing::ThrowsMessage<CancelledException>(
                  testing::HasSubstr("cancelled during wall")));
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
