#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/voxel_windows.h>

#include <algorithm>

namespace pcl::acmap {

VoxelWindows::VoxelWindows(const VoxelMoments& voxels)
: voxels_(voxels)
{
  keys_.resize(voxels.cells.size());
  parallelForChunks(keys_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
      keys_[c] = voxels.cells[c].key;
  });
  for (std::size_t c = 0; c < keys_.size(); ++c)
    if (c == 0 || voxelOf(keys_[c]) != voxelOf(keys_[c - 1]))
      begins_.push_back(c);
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
