#pragma once

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Blocks [begin, end) of a row. */
struct FilledRun {
  std::int32_t row, begin, end;
};

/** \brief A bit map of blocks, one byte each, in rows; layers of rows follow each
 * other. */
struct BlockMarks {
  std::vector<std::uint8_t> marks;
  std::int64_t blocks = 0; ///< of a row
  std::int64_t rows = 0;   ///< of a layer
};

/** \brief The marked blocks and those near them, in the order of rows.
 * \param[in] before, after how many rows of the same layer they reach beyond marks
 * \param[out] runs keep their memory, here and below */
void
findRuns(const BlockMarks& blocks,
         std::int64_t before,
         std::int64_t after,
         std::vector<FilledRun>& runs);

/** \brief Runs that reach some blocks farther to both sides, within their rows; those
 * that meet become one.
 * \param[in] blocks of a row */
void
widenRuns(const std::vector<FilledRun>& runs,
          std::int32_t aside,
          std::int32_t blocks,
          std::vector<FilledRun>& wide);

} // namespace pcl::acmap
