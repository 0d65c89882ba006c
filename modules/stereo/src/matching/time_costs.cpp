#include "time_costs.h"

#include <algorithm>

namespace pcl::acmap {

namespace {

/** Codes of the pixels of a row. */
class CodeRow {
public:
  CodeRow(const ShotStack& stack, int behind)
  : stack_(stack)
  , size_((stack.width() + behind + 7) / 8 * 8)
  , pairs_((stack.shots() + 1) / 2)
  , floor_(variance_floor * ShotStack::unit * ShotStack::unit *
           static_cast<float>(stack.shots()))
  , codes_(static_cast<std::size_t>(size_) * static_cast<std::size_t>(pairs_))
  {}

  void
  fill(int y)
  {
    byteKernels().encode(stack_.rows(y), size_, floor_, size_, codes_.data());
  }

  ShotRows<std::int32_t>
  from(int x) const
  {
    return {codes_.data() + x, size_, pairs_};
  }

private:
  const ShotStack& stack_;
  int size_, pairs_;
  float floor_;
  std::vector<std::int32_t> codes_;
};

/** As in \ref fillCosts: the cost of a position outside the neighbour's image. */
constexpr std::uint8_t outside_byte_cost = 115;

void
markOutsideBytes(const DisparityRange& range, const ByteRow& row)
{
  for (int x = 0; x < row.width; ++x) {
    std::uint8_t* const costs = row.values + static_cast<std::int64_t>(x) * row.stride;
    const int inside = std::clamp(row.width - x - range.first, 0, range.count);
    std::fill(costs + inside, costs + range.count, outside_byte_cost);
    std::fill(costs + range.count, costs + row.stride, filled_byte_cost);
  }
}

} // namespace

void
fillTimeCosts(const ShotStack& reference,
              const ShotStack& target,
              const DisparityRange& range,
              ByteVolume& costs)
{
  const int stride = range.stride(byte_block);
  costs.resize(reference.width(), reference.height(), stride);
  forRowBlocks(costs.height, [&](int begin, int end) {
    CodeRow codes(reference, 0), target_codes(target, range.first + stride);
    for (int y = begin; y < end; ++y) {
      codes.fill(y);
      target_codes.fill(y);
      byteKernels().correlate(
          codes.from(0), target_codes.from(range.first), costs.row(y));
      markOutsideBytes(range, costs.row(y));
    }
  });
}

} // namespace pcl::acmap
