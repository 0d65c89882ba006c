#pragma once

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Blocks [begin, end) of a row. */
struct FilledRun {
  std::int32_t row, begin, end;
};

/** \brief A map of marked blocks, one byte each, in rows; the rows of all layers are
 * consecutive. */
struct BlockMarks {
  std::vector<std::uint8_t> marks;
  std::int64_t blocks = 0; ///< per row
  std::int64_t rows = 0;   ///< per layer
};

/** \brief The marks as bits. */
class BlockBits {
public:
  /** \param[in] blocks marks of 0 or 1 */
  explicit BlockBits(const BlockMarks& blocks);

  /** \brief Finds the runs of marked blocks and those near them, in the order of rows.
   * \param[in] before, after number of rows of the same layer by which they extend
   * beyond marks
   * \param[in] aside number of blocks of the same row by which they extend to both
   * sides
   * \param[out] runs their memory is reused */
  void
  findRuns(std::int64_t before,
           std::int64_t after,
           std::int64_t aside,
           std::vector<FilledRun>& runs) const;

private:
  void
  widen(std::vector<std::uint64_t>& row, std::int64_t aside) const;

  std::int64_t blocks_, rows_, all_rows_;
  std::int64_t words_;              ///< per row
  std::vector<std::uint64_t> bits_; ///< the lowest bit is the first block
};

} // namespace pcl::acmap
