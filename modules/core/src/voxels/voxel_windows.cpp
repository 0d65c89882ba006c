#include <pcl/core/impl/voxel_windows.h>

#include <algorithm>

namespace pcl::acmap {

VoxelWindows::VoxelWindows(const VoxelMoments& voxels)
: voxels_(voxels)
{
  const auto& cells = voxels.cells;
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (c == 0 || voxelOf(cells[c].key) != voxelOf(cells[c - 1].key))
      begins_.push_back(c);
  begins_.push_back(cells.size());
}

VoxelWindows::Cursor::Cursor(const VoxelWindows& windows, int reach)
: windows_(windows)
, reach_(reach)
{}

std::size_t
VoxelWindows::Cursor::firstCellFrom(VoxelKey key) const
{
  const auto& cells = windows_.voxels_.cells;
  const auto found = std::lower_bound(
      cells.begin(), cells.end(), key, [](const VoxelCell& cell, VoxelKey minimum) {
        return cell.key < minimum;
      });
  return static_cast<std::size_t>(found - cells.begin());
}

const std::vector<WindowPart>&
VoxelWindows::Cursor::moveTo(std::size_t voxel)
{
  parts_.clear();
  const auto& cells = windows_.voxels_.cells;
  const VoxelPlace middle = placeOf(cells[windows_.begins_[voxel]].key);
  const bool starts = rows_.empty();
  std::size_t row = 0;
  for (int dx = -reach_; dx <= reach_; ++dx)
    for (int dy = -reach_; dy <= reach_; ++dy, ++row) {
      const VoxelKey begin =
          voxelKey({middle[0] + dx, middle[1] + dy, middle[2] - reach_});
      const VoxelKey end =
          voxelKey({middle[0] + dx, middle[1] + dy, middle[2] + reach_ + 1});
      if (starts)
        rows_.push_back(firstCellFrom(begin));
      std::size_t& place = rows_[row];
      while (place < cells.size() && cells[place].key < begin)
        ++place;
      for (std::size_t c = place; c < cells.size() && cells[c].key < end; ++c)
        parts_.push_back(
            {static_cast<std::uint32_t>(c),
             static_cast<std::int8_t>(dx),
             static_cast<std::int8_t>(dy),
             static_cast<std::int8_t>(placeOf(cells[c].key)[2] - middle[2])});
    }
  return parts_;
}

} // namespace pcl::acmap
