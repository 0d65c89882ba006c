#include "process_use.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <fstream>
#include <mutex>
#include <thread>
#include <vector>

namespace pcl::acmap::test {
namespace {

constexpr std::ptrdiff_t some_bytes = 4 << 20;

TEST(ProcessUse, memoryThatIsHeldIsSeen)
{
  const ProcessUse before = currentUse();
  const std::vector<std::vector<char>> held(1024, std::vector<char>(4096, 1));
  const ProcessUse growth = currentUse() - before;
  EXPECT_GE(growth.allocated, some_bytes);
  EXPECT_LT(growth.allocated, 2 * some_bytes);
  if (before.resident > 0) {
    EXPECT_GE(growth.resident, some_bytes / 2);
  }
  EXPECT_EQ(held.back().back(), 1);
}

TEST(ProcessUse, memoryThatWasGivenBackIsNot)
{
  const ProcessUse before = currentUse();
  for (int i = 0; i < 100; ++i)
    std::vector<char>(static_cast<std::size_t>(some_bytes), 1).clear();
  const ProcessUse growth = currentUse() - before;
  EXPECT_LT(growth.allocated, 64 << 10);
  EXPECT_LT(growth.resident, some_bytes);
}

TEST(ProcessUse, openFilesAreSeen)
{
  const ProcessUse before = currentUse();
  const std::ifstream file("/dev/null");
  EXPECT_EQ((currentUse() - before).files, 1);
}

TEST(ProcessUse, threadsAreSeen)
{
  const ProcessUse before = currentUse();
  std::mutex mutex;
  std::condition_variable changed;
  bool done = false;
  std::thread waiting([&] {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return done; });
  });
  EXPECT_EQ((currentUse() - before).threads, 1);
  {
    const std::lock_guard lock(mutex);
    done = true;
  }
  changed.notify_one();
  waiting.join();
}

} // namespace
} // namespace pcl::acmap::test
