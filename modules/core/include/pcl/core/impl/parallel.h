#pragma once

#include <pcl/core/impl/arena_lease.h>
#include <pcl/core/progress.h>

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief Chunk length of the loops below: long enough to hide the scheduling overhead,
 * and fixed, so that the grouping of sums does not depend on the number of threads. */
inline constexpr std::size_t parallel_chunk = 4096;

/** \brief Runs a function in an arena of \a threads threads (0 for all), even if these
 * are more than the processors of the machine. */
template <typename Function>
auto
withThreads(unsigned threads, Function&& function)
{
  using oneapi::tbb::global_control;
  std::optional<global_control> allowed;
  if (threads > global_control::active_value(global_control::max_allowed_parallelism))
    allowed.emplace(global_control::max_allowed_parallelism, threads);
  const ArenaLease arena(threads);
  return (*arena).execute(std::forward<Function>(function));
}

/** \brief Calls body (begin, end) for each chunk of [0, size), in any order.
 * \throws CancelledException as \ref pollRun */
template <typename Body>
void
parallelForChunks(std::size_t size, const Body& body)
{
  const std::size_t chunks = (size + parallel_chunk - 1) / parallel_chunk;
  oneapi::tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t chunk) {
    const std::size_t begin = chunk * parallel_chunk;
    body(begin, std::min(begin + parallel_chunk, size));
    pollRun();
  });
}

/** \brief Reduces the results of chunks in the order of the chunks. The result is
 * bitwise identical for any number of threads, including floating-point sums.
 * \param[in] map returns the value of chunk (begin, end)
 * \param[in] join joins the value of the next chunk into the first argument, which is
 * passed by reference */
template <typename Value, typename Map, typename Join>
Value
parallelReduceChunks(std::size_t size, Value start, const Map& map, const Join& join)
{
  const std::size_t chunks = (size + parallel_chunk - 1) / parallel_chunk;
  std::vector<Value> values(chunks, start);
  parallelForChunks(size, [&](std::size_t begin, std::size_t end) {
    values[begin / parallel_chunk] = map(begin, end);
  });
  for (const Value& value : values)
    join(start, value);
  return start;
}

} // namespace pcl::acmap
