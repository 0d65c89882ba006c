#include "voxels/shared_cells.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>

namespace pcl::acmap {

namespace {

/** The cells of a part in ascending order of their keys. */
struct SortedPart {
  std::vector<VoxelCell> cells;
  std::vector<ColorSum> colors;
};

SortedPart
sorted(const CellTable& table, double edge)
{
  std::vector<std::pair<VoxelKey, std::size_t>> order;
  order.reserve(table.cells.size());
  for (std::size_t c = 0; c < table.cells.size(); ++c)
    order.emplace_back(table.cells[c].key, c);
  std::sort(order.begin(), order.end());
  SortedPart part;
  part.cells.reserve(order.size());
  part.colors.reserve(table.colors.size());
  for (const auto& [key, cell] : order) {
    part.cells.push_back(toVoxelCell(table.cells[cell], edge));
    if (!table.colors.empty())
      part.colors.push_back(table.colors[cell]);
  }
  return part;
}

} // namespace

void
SharedCells::join(const CellTable& cells)
{
  std::vector<std::vector<std::size_t>> of_parts(parts_.size());
  for (std::size_t c = 0; c < cells.cells.size(); ++c) {
    const auto limit =
        std::upper_bound(limits_.begin(), limits_.end(), cells.cells[c].key);
    of_parts[static_cast<std::size_t>(limit - limits_.begin())].push_back(c);
  }
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    if (of_parts[p].empty())
      continue;
    const std::lock_guard lock(parts_[p].mutex);
    for (const std::size_t cell : of_parts[p])
      parts_[p].table.join(cells, cell);
  }
}

void
SharedCells::moveTo(VoxelMoments& voxels)
{
  std::size_t cells = 0, colors = 0;
  for (const Part& part : parts_) {
    cells += part.table.cells.size();
    colors += part.table.colors.size();
  }
  voxels.cells.reserve(cells);
  voxels.colors.reserve(colors);
  constexpr std::size_t at_a_time = 8;
  for (std::size_t begin = 0; begin < parts_.size(); begin += at_a_time) {
    std::vector<SortedPart> some(std::min(at_a_time, parts_.size() - begin));
    oneapi::tbb::parallel_for(std::size_t{0}, some.size(), [&](std::size_t k) {
      CellTable& table = parts_[begin + k].table;
      some[k] = sorted(table, voxels.lattice.edge());
      table = CellTable();
    });
    for (const SortedPart& part : some) {
      voxels.cells.insert(voxels.cells.end(), part.cells.begin(), part.cells.end());
      voxels.colors.insert(voxels.colors.end(), part.colors.begin(), part.colors.end());
    }
  }
}

} // namespace pcl::acmap
