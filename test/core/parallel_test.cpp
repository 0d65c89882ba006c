#include <pcl/core/impl/parallel.h>
#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

namespace pcl::acmap::test {
namespace {

constexpr unsigned thread_counts[] = {1, 2, 8, 0};

TEST(ParallelForChunks, visitsEachIndexOnce)
{
  for (const std::size_t size : {std::size_t{0},
                                 std::size_t{1},
                                 parallel_chunk,
                                 parallel_chunk + 1,
                                 7 * parallel_chunk - 1})
    for (const unsigned threads : thread_counts) {
      std::vector<std::atomic<int>> visits(size);
      withThreads(threads, [&] {
        parallelForChunks(size, [&](std::size_t begin, std::size_t end) {
          ASSERT_LT(begin, end);
          ASSERT_LE(end - begin, parallel_chunk);
          for (std::size_t i = begin; i < end; ++i)
            ++visits[i];
        });
      });
      for (const auto& count : visits)
        ASSERT_EQ(count, 1);
    }
}

TEST(ParallelReduceChunks, givesTheSameBytesForAnyNumberOfThreads)
{
  Random random(1);
  std::vector<float> values(300000);
  for (float& value : values)
    value = static_cast<float>(random.normal() * 1e6);
  const auto sum_with = [&](unsigned threads) {
    return withThreads(threads, [&] {
      return parallelReduceChunks(
          values.size(),
          0.0F,
          [&](std::size_t begin, std::size_t end) {
            float sum = 0.0F;
            for (std::size_t i = begin; i < end; ++i)
              sum += values[i];
            return sum;
          },
          [](float& sum, float next) { sum += next; });
    });
  };
  const float expected = sum_with(1);
  for (int run = 0; run < 5; ++run)
    for (const unsigned threads : thread_counts)
      ASSERT_EQ(sum_with(threads), expected);
}

TEST(ParallelReduceChunks, joinsInOrder)
{
  const auto chunks = parallelReduceChunks(
      10 * parallel_chunk,
      std::vector<std::size_t>(),
      [](std::size_t begin, std::size_t) {
        return std::vector{begin / parallel_chunk};
      },
      [](auto& all, const auto& next) {
        all.insert(all.end(), next.begin(), next.end());
      });
  ASSERT_EQ(chunks.size(), 10U);
  for (std::size_t i = 0; i < chunks.size(); ++i)
    EXPECT_EQ(chunks[i], i);
}

TEST(ParallelReduceChunks, givesTheStartForNothing)
{
  EXPECT_EQ(parallelReduceChunks(
                0,
                42,
                [](std::size_t, std::size_t) { return 0; },
                [](int& sum, int next) { sum += next; }),
            42);
}

TEST(WithThreads, limitsTheThreads)
{
  for (const unsigned threads : {1U, 2U, 8U})
    EXPECT_EQ(
        withThreads(threads,
                    [] { return oneapi::tbb::this_task_arena::max_concurrency(); }),
        static_cast<int>(threads));
}

TEST(ParallelForChunks, passesExceptionsOn)
{
  for (const unsigned threads : thread_counts)
    EXPECT_THROW(withThreads(threads,
                             [] {
                               parallelForChunks(100 * parallel_chunk,
                                                 [](std::size_t begin, std::size_t) {
                                                   if (begin == 50 * parallel_chunk)
                                                     throw std::runtime_error(
                                                         "in a chunk");
                                                 });
                             }),
                 std::runtime_error);
}

} // namespace
} // namespace pcl::acmap::test
