#include <pcl/core/impl/parallel.h>

#include <chrono>
#include <cstdio>
#include <thread>

/** Adds to one number from all threads, which ThreadSanitizer must report. */
int
main()
{
  std::size_t sum = 0;
  pcl::acmap::parallelForChunks(
      64 * pcl::acmap::parallel_chunk, [&](std::size_t begin, std::size_t end) {
        sum += end - begin;
        std::this_thread::sleep_for(
            std::chrono::milliseconds(1)); // long enough for other threads to take part
      });
  std::printf("%zu\n", sum);
}
