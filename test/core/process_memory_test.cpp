#include <pcl/core/exceptions.h>
#include <pcl/core/process_memory.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <new>
#include <vector>

namespace pcl::acmap::test {
namespace {

constexpr std::size_t megabyte = std::size_t{1} << 20;

TEST(ProcessMemory, WhatNoMachineHasIsRefused)
{
  EXPECT_EQ(memoryLimit(), 0U);
  EXPECT_GT(availableMemory(), megabyte);
  EXPECT_GT(peakMemory(), megabyte);
  EXPECT_NO_THROW(requireMemory(1, "a byte"));
  try {
    requireMemory(std::numeric_limits<std::size_t>::max() / 2, "the map");
    FAIL() << "not refused";
  }
  catch (const MemoryLimitException& refused) {
    EXPECT_EQ(std::string(refused.what()).rfind("the map needs about", 0), 0U);
  }
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
/** \return 0 if a process with a limit refuses what is beyond it, and nothing else */
int
runWithLimit()
{
  limitMemory(200 * megabyte, 1);
  if (memoryLimit() != 200 * megabyte || availableMemory() > memoryLimit() ||
      residentScratch() != 50 * megabyte)
    return 1;
  try {
    requireMemory(300 * megabyte, "too much");
    return 2;
  }
  catch (const MemoryLimitException&) {
  }
  std::vector<char> small(100 * megabyte);
  if (availableMemory() > 101 * megabyte)
    return 3;
  {
    const UnlimitedMemory while_drawing;
    const std::vector<char> large(400 * megabyte);
  }
  try {
    const std::vector<char> large(400 * megabyte);
    return 4;
  }
  catch (const std::bad_alloc&) {
    return 0;
  }
}

TEST(ProcessMemory, ALimitHoldsForOneProcess)
{
  EXPECT_EXIT(std::exit(runWithLimit()), testing::ExitedWithCode(0), "");
}
#endif

} // namespace
} // namespace pcl::acmap::test
