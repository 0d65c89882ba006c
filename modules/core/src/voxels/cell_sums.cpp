#include "voxels/cell_sums.h"

namespace pcl::acmap {

namespace {

constexpr VoxelKey no_key = ~VoxelKey{0};
constexpr int min_bits = 4, max_bits = 12; // of the initial number of slots

std::size_t
slotOf(VoxelKey key, int shift)
{
  return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15u) >> shift);
}

} // namespace

void
CellSums::join(const CellSums& other)
{
  offerWitness(other.witness, other.squared_range);
  count += other.count;
  for (int k = 0; k < 3; ++k) {
    first[k] += other.first[k];
    way[k] += other.way[k];
  }
  for (int k = 0; k < 6; ++k)
    second[k] += other.second[k];
}

VoxelCell
toVoxelCell(const CellSums& sums, double edge)
{
  constexpr double tick = 1.0 / (1 << VoxelLattice::offset_bits);
  // offsets are rounded down, so the points are half a tick further on average
  Moments centered;
  centered.count = sums.count;
  centered.x = tick * static_cast<double>(sums.first[0]);
  centered.y = tick * static_cast<double>(sums.first[1]);
  centered.z = tick * static_cast<double>(sums.first[2]);
  centered.xx = tick * tick * static_cast<double>(sums.second[0]);
  centered.xy = tick * tick * static_cast<double>(sums.second[1]);
  centered.xz = tick * tick * static_cast<double>(sums.second[2]);
  centered.yy = tick * tick * static_cast<double>(sums.second[3]);
  centered.yz = tick * tick * static_cast<double>(sums.second[4]);
  centered.zz = tick * tick * static_cast<double>(sums.second[5]);
  VoxelCell cell;
  cell.key = sums.key;
  cell.moments.addShifted(centered, tick / 2, tick / 2, tick / 2);
  cell.witness = sums.witness;
  cell.range = std::sqrt(sums.squared_range);
  for (int axis = 0; axis < 3; ++axis)
    cell.way[axis] = static_cast<float>(static_cast<double>(sums.way[axis]) * edge /
                                        (way_steps * sums.count));
  return cell;
}

CellTable::CellTable(std::size_t maximum)
{
  int bits = min_bits;
  while (bits < max_bits && std::size_t{1} << bits < 2 * maximum)
    ++bits;
  slots_.assign(std::size_t{1} << bits, Slot{no_key, 0});
  shift_ = 64 - bits;
  cells.reserve(maximum);
}

std::size_t
CellTable::find(VoxelKey key)
{
  for (std::size_t s = slotOf(key, shift_);; s = (s + 1) & (slots_.size() - 1)) {
    Slot& slot = slots_[s];
    if (slot.key == key)
      return slot.cell;
    if (slot.key != no_key)
      continue;
    if (2 * (cells.size() + 1) > slots_.size()) {
      grow();
      return find(key);
    }
    slot = {key, static_cast<std::uint32_t>(cells.size())};
    cells.emplace_back().key = key;
    return slot.cell;
  }
}

void
CellTable::join(const CellTable& other, std::size_t cell)
{
  const CellSums& more = other.cells[cell];
  const std::size_t own = find(more.key);
  if (cells[own].count == 0)
    cells[own] = more;
  else
    cells[own].join(more);
  if (other.colors.empty())
    return;
  colors.resize(cells.size());
  colors[own].red += other.colors[cell].red;
  colors[own].green += other.colors[cell].green;
  colors[own].blue += other.colors[cell].blue;
}

void
CellTable::clear()
{
  cells.clear();
  colors.clear();
  std::fill(slots_.begin(), slots_.end(), Slot{no_key, 0});
}

void
CellTable::grow()
{
  --shift_;
  slots_.assign(2 * slots_.size(), Slot{no_key, 0});
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    std::size_t s = slotOf(cells[cell].key, shift_);
    while (slots_[s].key != no_key)
      s = (s + 1) & (slots_.size() - 1);
    slots_[s] = {cells[cell].key, static_cast<std::uint32_t>(cell)};
  }
}

} // namespace pcl::acmap
