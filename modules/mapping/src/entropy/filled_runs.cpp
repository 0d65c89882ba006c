#include "filled_runs.h"

#include <algorithm>
#include <cstring>

namespace pcl::acmap {
namespace {

/** The next block from \a at on that is marked or, with \a mark 0, that is not. */
std::int64_t
findMark(const std::uint8_t* row, std::int64_t at, std::int64_t size, int mark)
{
  const void* found =
      at < size ? std::memchr(row + at, mark, static_cast<std::size_t>(size - at))
                : nullptr;
  return found ? static_cast<const std::uint8_t*>(found) - row : size;
}

/** Runs of one row. */
void
addRuns(const std::uint8_t* marks,
        std::int64_t row,
        std::int64_t blocks,
        std::vector<FilledRun>& runs)
{
  for (std::int64_t end = 0; end < blocks;) {
    const std::int64_t begin = findMark(marks, end, blocks, 1);
    end = findMark(marks, begin, blocks, 0);
    if (begin < end)
      runs.push_back({static_cast<std::int32_t>(row),
                      static_cast<std::int32_t>(begin),
                      static_cast<std::int32_t>(end)});
  }
}

void
addMarks(const std::uint8_t* marks, std::int64_t size, std::uint8_t* sum)
{
  for (std::int64_t i = 0; i < size; ++i)
    sum[i] |= marks[i];
}

} // namespace

void
findRuns(const BlockMarks& blocks,
         std::int64_t before,
         std::int64_t after,
         std::vector<FilledRun>& runs)
{
  runs.clear();
  const std::int64_t size = blocks.blocks;
  const auto all_rows = static_cast<std::int64_t>(blocks.marks.size()) / size;
  std::vector<std::uint8_t> around(static_cast<std::size_t>(size));
  for (std::int64_t row = 0; row < all_rows; ++row) {
    const std::int64_t layer = row / blocks.rows * blocks.rows;
    const std::int64_t first = std::max(row - after, layer);
    const std::int64_t last = std::min(row + before, layer + blocks.rows - 1);
    std::fill(around.begin(), around.end(), std::uint8_t{0});
    for (std::int64_t near = first; near <= last; ++near)
      addMarks(
          &blocks.marks[static_cast<std::size_t>(near * size)], size, around.data());
    addRuns(around.data(), row, size, runs);
  }
}

void
widenRuns(const std::vector<FilledRun>& runs,
          std::int32_t aside,
          std::int32_t blocks,
          std::vector<FilledRun>& wide)
{
  wide.clear();
  for (const FilledRun& run : runs) {
    const std::int32_t begin = std::max(run.begin - aside, 0);
    const std::int32_t end = std::min(run.end + aside, blocks);
    if (!wide.empty() && wide.back().row == run.row && wide.back().end >= begin)
      wide.back().end = end;
    else
      wide.push_back({run.row, begin, end});
  }
}

} // namespace pcl::acmap
