#include "repetitions.h"

#include <pcl/core/cloud_rows.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/depth_view.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/scratch_memory.h>

#include <sys/mman.h>
#include <sys/resource.h>

#include <gtest/gtest.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>

namespace pcl::acmap::test {

namespace {

#if defined(__SANITIZE_THREAD__)
constexpr bool is_thread_sanitized = true;
#elif defined(__has_feature)
constexpr bool is_thread_sanitized = __has_feature(thread_sanitizer);
#else
constexpr bool is_thread_sanitized = false;
#endif
constexpr std::size_t mega = std::size_t{1} << 20;
constexpr std::size_t least_resident = 16 * mega;

std::string
emptyFolder(const char* name)
{
  const std::string folder = testing::TempDir() + name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

struct Resident {
  std::size_t all, files; ///< bytes of this process, and those of mapped files
};

Resident
residentNow()
{
  std::ifstream table("/proc/self/statm");
  std::size_t size = 0, resident = 0, of_files = 0;
  table >> size >> resident >> of_files;
  return {4096 * resident, 4096 * of_files};
}

std::size_t
residentFiles()
{
  return residentNow().files;
}

/** The thread that limits it may have to wait for a processor. */
template <typename Measure>
bool
becomesLess(const Measure& measure, std::size_t limit)
{
  for (int attempt = 0; attempt < 1000; ++attempt) {
    if (measure() < limit)
      return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

std::uint64_t
valueAt(std::size_t i)
{
  return i * 0x9e3779b97f4a7c15u;
}

LargeVector<std::uint64_t>
filled(std::size_t bytes)
{
  LargeVector<std::uint64_t> values(bytes / sizeof(std::uint64_t));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = valueAt(i);
  return values;
}

std::size_t
countWrong(const LargeVector<std::uint64_t>& values)
{
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    wrong += values[i] != valueAt(i) ? 1 : 0;
  return wrong;
}

TEST(ScratchMemory, KeepsWhatIsTakenOutOfMemory)
{
  const ScratchMemory scratch(emptyFolder("scratch_keeps"), least_resident);
  const std::size_t before = residentFiles();
  const LargeVector<std::uint64_t> first = filled(128 * mega),
                                   second = filled(64 * mega);
  EXPECT_EQ(scratch.getBytes(), 192 * mega);
  EXPECT_EQ(scratch.getRefused(), 0u);
  EXPECT_TRUE(becomesLess([] { return residentFiles(); }, before + 2 * least_resident));
  EXPECT_EQ(countWrong(first), 0u);
  EXPECT_EQ(countWrong(second), 0u);
}

TEST(ScratchMemory, LetsFilesHaveWhatTheProcessLeaves)
{
  if (is_thread_sanitized)
    GTEST_SKIP() << "the sanitizer's memory, several times that of the arrays, is the "
                    "process's";
  const auto [all, before] = residentNow();
  const ScratchMemory scratch(
      emptyFolder("scratch_process"), least_resident, all + 128 * mega);
  const LargeVector<std::uint64_t> first = filled(64 * mega);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_GT(residentFiles(), before + 60 * mega); // nothing was taken out
  const LargeVector<std::uint64_t> second = filled(128 * mega);
  EXPECT_TRUE(becomesLess([] { return residentFiles(); }, before + 130 * mega));
  const std::vector<char> others(160 * mega, 1);
  EXPECT_EQ(countWrong(first), 0u);
  EXPECT_TRUE(becomesLess([] { return residentFiles(); }, before + 2 * least_resident));
  EXPECT_EQ(countWrong(second), 0u);
  EXPECT_EQ(others.back(), 1);
}

/** Bytes that this process had in memory at most, since the last call. */
std::size_t
peakSinceLastCall()
{
  std::size_t kilobytes = 0;
  std::ifstream table("/proc/self/status");
  for (std::string line; std::getline(table, line);)
    if (line.rfind("VmHWM:", 0) == 0)
      kilobytes = std::stoul(line.substr(6));
  std::ofstream("/proc/self/clear_refs") << 5;
  return 1024 * kilobytes;
}

/** Each of these points brings in the pages around it. */
TEST(ScratchMemory, StaysSmallWherePointsAreLookedAtFarApart)
{
  if (is_thread_sanitized)
    GTEST_SKIP() << "the sanitizer needs gigabytes for it";
  const ScratchMemory scratch(emptyFolder("scratch_far"), least_resident);
  LargeVector<Eigen::Vector3f> points(48 * mega);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % parallel_chunk == 0)
      keepScratchSmall();
    points[i] = {0, 0, 1 + static_cast<float>(i % 1000)};
  }
  EXPECT_TRUE(becomesLess([] { return residentFiles(); }, 4 * least_resident));
  const std::size_t before = residentNow().all;
  peakSinceLastCall();
  measureDepthStep(PointView(points.data(), sizeof points[0], points.size()));
  EXPECT_LT(peakSinceLastCall(), before + 12 * least_resident);
}

TEST(ScratchMemory, LeavesNoFileAndNoMappingBehind)
{
  const std::string folder = emptyFolder("scratch_leaves");
  std::size_t mapped = 0;
  {
    const ScratchMemory scratch(folder, least_resident);
    const LargeVector<std::uint64_t> values = filled(32 * mega);
    EXPECT_TRUE(std::filesystem::is_empty(folder));
  }
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);)
    mapped += line.find("scratch_leaves") != std::string::npos ? 1 : 0;
  EXPECT_EQ(mapped, 0u);
}

TEST(ScratchMemory, TakesOnlyLargeArraysWhileItExists)
{
  const std::string folder = emptyFolder("scratch_only");
  LargeVector<std::uint64_t> longer_lived;
  {
    const ScratchMemory outer(folder, least_resident);
    {
      const ScratchMemory inner(folder, least_resident);
      longer_lived = filled(8 * mega);
      const LargeVector<std::uint64_t> small = filled(mega / 8);
      EXPECT_EQ(inner.getBytes(), 8 * mega);
      EXPECT_EQ(outer.getBytes(), 0u);
    }
    const LargeVector<std::uint64_t> next = filled(8 * mega);
    EXPECT_EQ(outer.getBytes(), 8 * mega);
  }
  EXPECT_EQ(countWrong(longer_lived), 0u);
  longer_lived = filled(8 * mega); // released and allocated without any
  EXPECT_EQ(countWrong(longer_lived), 0u);
}

/** The memory of a released array must not be touched when another mapping has taken its
 * address: the content of a private mapping would be lost. */
TEST(ScratchMemory, NeverTouchesOtherMappings)
{
  const ScratchMemory scratch(emptyFolder("scratch_others"), least_resident);
  std::size_t lost = 0;
  std::thread others([&lost] {
    for (int round = 0; round < repetitions(60, 300); ++round) {
      constexpr std::size_t bytes = 8 * mega;
      void* const memory = ::mmap(
          nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
      std::memset(memory, 7, bytes);
      for (std::size_t i = 0; i < bytes; i += 4096)
        lost += static_cast<const char*>(memory)[i] != 7 ? 1 : 0;
      ::munmap(memory, bytes);
    }
  });
  for (int round = 0; round < repetitions(4, 20); ++round)
    EXPECT_EQ(countWrong(filled(24 * mega)), 0u);
  others.join();
  EXPECT_EQ(lost, 0u);
}

TEST(ScratchMemory, StaysInMemoryWhereTheDiskIsFull)
{
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before = {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit small = before;
  small.rlim_cur = mega;
  const ScratchMemory scratch(emptyFolder("scratch_full"), least_resident);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const LargeVector<std::uint64_t> values = filled(8 * mega);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  EXPECT_EQ(scratch.getBytes(), 0u);
  EXPECT_EQ(scratch.getRefused(), 8 * mega);
  EXPECT_EQ(countWrong(values), 0u);
}

TEST(ScratchMemory, RefusesWhatIsNoFolder)
{
  EXPECT_THROW(ScratchMemory("/no/such/folder", least_resident), OutputFileException);
  EXPECT_THROW(ScratchMemory(emptyFolder("scratch_little"), mega),
               BadArgumentException);
}

PCLPointCloud2
layoutOfTwoFloats()
{
  PCLPointCloud2 layout;
  layout.point_step = 8;
  return layout;
}

TEST(CloudRows, SharesACloudOrHasRowsOfItsOwn)
{
  const auto cloud = std::make_shared<PCLPointCloud2>(layoutOfTwoFloats());
  cloud->width = 3;
  cloud->height = 1;
  cloud->data.assign(24, 5);
  const CloudRows shared(cloud);
  EXPECT_EQ(shared.data(), cloud->data.data());
  EXPECT_EQ(shared.size(), 3u);
  const CloudRows own(layoutOfTwoFloats(), LargeVector<std::uint8_t>(24, 5));
  EXPECT_EQ(own.size(), 3u);
  EXPECT_EQ(own.layout().width, 3u);
  EXPECT_EQ(own.copy().data, cloud->data);
}

TEST(CloudRows, IsNoCloudWithoutOne)
{
  EXPECT_FALSE(CloudRows());
  EXPECT_FALSE(CloudRows(PCLPointCloud2ConstPtr()));
  EXPECT_EQ(CloudRows().size(), 0u);
}

TEST(CloudRows, RefusesPartsOfRows)
{
  EXPECT_THROW(CloudRows(layoutOfTwoFloats(), LargeVector<std::uint8_t>(23)),
               BadArgumentException);
  EXPECT_THROW(CloudRows(PCLPointCloud2(), LargeVector<std::uint8_t>(24)),
               BadArgumentException);
}

} // namespace
} // namespace pcl::acmap::test
