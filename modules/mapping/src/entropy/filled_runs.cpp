#include "filled_runs.h"

#include <algorithm>
#include <cstring>

namespace pcl::acmap {
namespace {

constexpr std::int64_t word_bits = 64;

/** Converts eight marks, the first one in the lowest byte, to bits: no sum of the
 * product carries into its highest byte. */
std::uint64_t
bitsOf(std::uint64_t marks)
{
  return (marks * 0x0102040810204080U) >> 56;
}

void
addBits(const std::uint8_t* marks, std::int64_t size, std::uint64_t* bits)
{
  constexpr std::int64_t bytes = 8;
  for (std::int64_t at = 0; at < size; at += bytes) {
    std::uint64_t eight = 0;
    if (at + bytes <= size)
      std::memcpy(&eight, marks + at, bytes);
    else
      std::memcpy(&eight, marks + at, static_cast<std::size_t>(size - at));
    bits[at / word_bits] |= bitsOf(eight) << (at % word_bits);
  }
}

/** Appends the runs of one word. \param[in] at block of its first bit */
void
addRuns(std::uint64_t word,
        std::int32_t row,
        std::int32_t at,
        std::vector<FilledRun>& runs)
{
  while (word != 0) {
    const int first = __builtin_ctzll(word);
    const std::uint64_t beyond = ~(word >> first);
    const int length = beyond ? __builtin_ctzll(beyond) : word_bits;
    if (first == 0 && !runs.empty() && runs.back().row == row && runs.back().end == at)
      runs.back().end += length;
    else
      runs.push_back({row, at + first, at + first + length});
    word &= word + (std::uint64_t{1} << first); // the carry clears the run
  }
}

} // namespace

BlockBits::BlockBits(const BlockMarks& blocks)
: blocks_(blocks.blocks)
, rows_(blocks.rows)
, all_rows_(static_cast<std::int64_t>(blocks.marks.size()) / blocks.blocks)
, words_((blocks.blocks + word_bits - 1) / word_bits)
, bits_(static_cast<std::size_t>(all_rows_ * words_), 0)
{
  for (std::int64_t row = 0; row < all_rows_; ++row)
    addBits(blocks.marks.data() + row * blocks_, blocks_, bits_.data() + row * words_);
}

void
BlockBits::findRuns(std::int64_t before,
                    std::int64_t after,
                    std::int64_t aside,
                    std::vector<FilledRun>& runs) const
{
  runs.clear();
  std::vector<std::uint64_t> around(static_cast<std::size_t>(words_));
  for (std::int64_t row = 0; row < all_rows_; ++row) {
    const std::int64_t layer = row / rows_ * rows_;
    const std::int64_t first = std::max(row - after, layer);
    const std::int64_t last = std::min(row + before, layer + rows_ - 1);
    for (std::int64_t word = 0; word < words_; ++word) {
      std::uint64_t sum = 0;
      for (std::int64_t near = first; near <= last; ++near)
        sum |= bits_[static_cast<std::size_t>(near * words_ + word)];
      around[static_cast<std::size_t>(word)] = sum;
    }
    widen(around, aside);
    for (std::int64_t word = 0; word < words_; ++word)
      addRuns(around[static_cast<std::size_t>(word)],
              static_cast<std::int32_t>(row),
              static_cast<std::int32_t>(word * word_bits),
              runs);
  }
}

void
BlockBits::widen(std::vector<std::uint64_t>& row, std::int64_t aside) const
{
  for (std::int64_t i = 0; i < aside; ++i) {
    std::uint64_t before = 0;
    for (std::size_t word = 0; word < row.size(); ++word) {
      const std::uint64_t bits = row[word];
      const std::uint64_t after = word + 1 < row.size() ? row[word + 1] : 0;
      row[word] |= bits << 1 | before >> 63 | bits >> 1 | after << 63;
      before = bits;
    }
  }
  if (blocks_ % word_bits != 0)
    row.back() &= (std::uint64_t{1} << (blocks_ % word_bits)) - 1;
}

} // namespace pcl::acmap
