#include "voxels/shared_cells.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>

namespace pcl::acmap {

namespace {

/** Writes the cells of a table in ascending order of their keys.
 * \param[out] first of the cells of the table
 * \param[out] first_color the same; not used without colours */
void
writeSorted(const CellTable& table,
            double edge,
            VoxelCell* first,
            ColorSum* first_color)
{
  std::vector<std::pair<VoxelKey, std::size_t>> order;
  order.reserve(table.cells.size());
  for (std::size_t c = 0; c < table.cells.size(); ++c) {
    if (c % parallel_chunk == 0)
      pollRun();
    order.emplace_back(table.cells[c].key, c);
  }
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i % parallel_chunk == 0)
      pollRun();
    const std::size_t cell = order[i].second;
    first[i] = toVoxelCell(table.cells[cell], edge);
    if (!table.colors.empty())
      first_color[i] = table.colors[cell];
  }
}

} // namespace

void
SharedCells::join(const CellTable& cells)
{
  std::vector<std::vector<std::uint32_t>> of_parts(parts_.size());
  for (std::size_t c = 0; c < cells.cells.size(); ++c) {
    const auto limit =
        std::upper_bound(limits_.begin(), limits_.end(), cells.cells[c].key);
    of_parts[static_cast<std::size_t>(limit - limits_.begin())].push_back(
        static_cast<std::uint32_t>(c));
  }
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    if (of_parts[p].empty())
      continue;
    const std::lock_guard lock(parts_[p].mutex);
    parts_[p].table.join(cells, of_parts[p]);
  }
}

void
SharedCells::moveTo(VoxelMoments& voxels)
{
  std::vector<std::size_t> begins;
  std::size_t cells = 0, colors = 0;
  for (const Part& part : parts_) {
    begins.push_back(cells);
    cells += part.table.cells.size();
    colors += part.table.colors.size();
  }
  voxels.cells.resize(cells);
  voxels.colors.resize(colors);
  oneapi::tbb::parallel_for(std::size_t{0}, parts_.size(), [&](std::size_t p) {
    CellTable& table = parts_[p].table;
    writeSorted(table,
                voxels.lattice.edge(),
                voxels.cells.data() + begins[p],
                voxels.colors.data() + (colors > 0 ? begins[p] : 0));
    table = CellTable();
  });
}

} // namespace pcl::acmap
