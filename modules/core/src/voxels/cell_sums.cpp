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
    cells.append().key = key;
    return slot.cell;
  }
}

/** The cells of a large table are far apart in memory: what a cell needs is requested
 * while earlier ones are joined. */
void
CellTable::join(const CellTable& other, const std::vector<std::uint32_t>& chosen)
{
  constexpr std::size_t ahead = 8;
  std::size_t own[ahead] = {};
  const auto keyOf = [&](std::size_t k) { return other.cells[chosen[k]].key; };
  for (std::size_t k = 0; k < chosen.size() + 2 * ahead; ++k) {
    if (k >= 2 * ahead)
      joinCell(own[k % ahead], other, chosen[k - 2 * ahead]);
    if (k >= ahead && k - ahead < chosen.size()) {
      own[k % ahead] = find(keyOf(k - ahead));
      requestCell(own[k % ahead]);
    }
    if (k < chosen.size())
      requestSlot(keyOf(k));
  }
}

void
CellTable::requestSlot(VoxelKey key) const
{
  __builtin_prefetch(&slots_[slotOf(key, shift_)], 1);
}

void
CellTable::requestCell(std::size_t cell) const
{
  const char* const first = reinterpret_cast<const char*>(&cells[cell]);
  __builtin_prefetch(first, 1);
  __builtin_prefetch(first + sizeof(CellSums) - 1, 1);
  if (cell < colors.size())
    __builtin_prefetch(&colors[cell], 1);
}

void
CellTable::joinCell(std::size_t own, const CellTable& other, std::size_t cell)
{
  const CellSums& more = other.cells[cell];
  if (cells[own].count == 0)
    cells[own] = more;
  else
    cells[own].join(more);
  if (other.colors.empty())
    return;
  colors.extendTo(cells.size());
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
  std::vector<Slot, SystemAllocator<Slot>> wider(2 * slots_.size(), Slot{no_key, 0});
  --shift_;
  for (const Slot& slot : slots_) {
    if (slot.key == no_key)
      continue;
    std::size_t s = slotOf(slot.key, shift_);
    while (wider[s].key != no_key)
      s = (s + 1) & (wider.size() - 1);
    wider[s] = slot;
  }
  slots_ = std::move(wider);
}

void
packCells(const CellTable& table, std::int32_t first, ByteParcel& parcel)
{
  parcel.put(table.cells.size());
  parcel.put(table.colors.size());
  for (std::size_t c = 0; c < table.cells.size(); ++c) {
    CellSums sums = table.cells[c];
    sums.witness += first;
    parcel.put(sums);
  }
  for (std::size_t c = 0; c < table.colors.size(); ++c)
    parcel.put(table.colors[c]);
}

CellTable
unpackedCells(ByteParcel& parcel)
{
  const auto cells = parcel.take<std::size_t>(), colors = parcel.take<std::size_t>();
  CellTable table(cells);
  for (std::size_t c = 0; c < cells; ++c)
    table.cells.append() = parcel.take<CellSums>();
  for (std::size_t c = 0; c < colors; ++c)
    table.colors.append() = parcel.take<ColorSum>();
  return table;
}

} // namespace pcl::acmap
