#include <pcl/core/impl/voxel_windows.h>

#include <algorithm>

namespace pcl::acmap {

VoxelWindows::VoxelWindows(const VoxelMoments& voxels)
: voxels_(voxels)
{
  keys_.reserve(voxels.cells.size());
  for (const VoxelCell& cell : voxels.cells) {
    if (keys_.empty() || voxelOf(cell.key) != voxelOf(keys_.back()))
      begins_.push_back(keys_.size());
    keys_.push_back(cell.key);
  }
  begins_.push_back(keys_.size());
}

VoxelWindows::Cursor::Cursor(const VoxelWindows& windows, int reach)
: windows_(windows)
, reach_(reach)
{}

std::size_t
VoxelWindows::Cursor::firstCellFrom(VoxelKey key) const
{
  const auto& keys = windows_.keys_;
  return static_cast<std::size_t>(std::lower_bound(keys.begin(), keys.end(), key) -
                                  keys.begin());
}

const std::vector<WindowPart>&
VoxelWindows::Cursor::moveTo(std::size_t voxel)
{
  parts_.clear();
  const auto& keys = windows_.keys_;
  const VoxelPlace middle = placeOf(keys[windows_.begins_[voxel]]);
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
      while (place < keys.size() && keys[place] < begin)
        ++place;
      for (std::size_t c = place; c < keys.size() && keys[c] < end; ++c)
        parts_.push_back({static_cast<std::uint32_t>(c),
                          static_cast<std::int8_t>(dx),
                          static_cast<std::int8_t>(dy),
                          static_cast<std::int8_t>(placeOf(keys[c])[2] - middle[2])});
    }
  return parts_;
}

} // namespace pcl::acmap
