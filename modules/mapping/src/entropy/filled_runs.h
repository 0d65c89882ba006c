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

/** \brief The same as bits. */
class BlockBits {
public:
  /** \param[in] blocks marks of 0 or 1 */
  explicit BlockBits(const BlockMarks& blocks);

  /** \brief The marked blocks and those near them, in the order of rows.
   * \param[in] before, after how many rows of the same layer they reach beyond marks
   * \param[in] aside how many blocks of the same row they reach farther to both sides
   * \param[out] runs keep their memory */
  void
  findRuns(std::int64_t before,
           std::int64_t after,
           std::int64_t aside,
           std::vector<FilledRun>& runs) const;

private:
  void
  widen(std::vector<std::uint64_t>& row, std::int64_t aside) const;

  std::int64_t blocks_, rows_, all_rows_;
  std::int64_t words_;              ///< of a row
  std::vector<std::uint64_t> bits_; ///< the lowest is the first block
};

} // namespace pcl::acmap
