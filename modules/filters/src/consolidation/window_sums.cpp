#include "consolidation/window_sums.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>

namespace pcl::acmap {

namespace {

/** As Moments::addShifted, for shifts across the rows. */
void
addAcross(const Moments& other, double dx, double dy, Moments& sum)
{
  const double n = other.count;
  sum.count += n;
  sum.xx += other.xx + dx * (2 * other.x + n * dx);
  sum.xy += other.xy + dx * other.y + dy * (other.x + n * dx);
  sum.xz += other.xz + dx * other.z;
  sum.yy += other.yy + dy * (2 * other.y + n * dy);
  sum.yz += other.yz + dy * other.z;
  sum.zz += other.zz;
  sum.x += other.x + n * dx;
  sum.y += other.y + n * dy;
  sum.z += other.z;
}

/** As Moments::addShifted, for shifts along a row. */
void
addAlong(const Moments& other, double dz, Moments& sum)
{
  const double n = other.count;
  sum.count += n;
  sum.xx += other.xx;
  sum.xy += other.xy;
  sum.xz += other.xz + dz * other.x;
  sum.yy += other.yy;
  sum.yz += other.yz + dz * other.y;
  sum.zz += other.zz + dz * (2 * other.z + n * dz);
  sum.x += other.x;
  sum.y += other.y;
  sum.z += other.z + n * dz;
}

} // namespace

WindowSums::WindowSums(const VoxelWindows& windows)
: keys_(windows.size())
, moments_(windows.size())
{
  const auto& cells = windows.voxels().cells;
  parallelForChunks(windows.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      keys_[v] = voxelOf(cells[windows.firstCell(v)].key);
      Moments sum;
      for (std::size_t c = windows.firstCell(v); c < windows.firstCell(v + 1); ++c)
        sum += cells[c].moments;
      moments_[v] = sum;
    }
  });
}

WindowSums::Cursor::Cursor(const WindowSums& sums)
: sums_(sums)
{}

WindowSum
WindowSums::Cursor::moveTo(std::size_t voxel)
{
  const VoxelPlace place = placeOf(sums_.keys_[voxel]);
  if (place_[0] < 0) {
    std::size_t row = 0;
    for (int dx = -2; dx <= 2; ++dx)
      for (int dy = -2; dy <= 2; ++dy)
        rows_[row++] = static_cast<std::size_t>(
            std::lower_bound(sums_.keys_.begin(),
                             sums_.keys_.end(),
                             voxelKey({place[0] + dx, place[1] + dy, place[2] - 2})) -
            sums_.keys_.begin());
  }
  const bool is_next_row = place[0] != place_[0] || place[1] != place_[1];
  place_ = place;
  next_plane_ = is_next_row ? place[2] - 2 : std::max(next_plane_, place[2] - 2);
  for (; next_plane_ <= place[2] + 2; ++next_plane_)
    planes_[static_cast<std::size_t>(next_plane_ & 7)] = sumPlane(next_plane_);
  WindowSum sum;
  for (int dz = -2; dz <= 2; ++dz) {
    const WindowSum& plane = planes_[static_cast<std::size_t>((place[2] + dz) & 7)];
    if (plane.whole.count == 0)
      continue;
    addAlong(plane.whole, dz, sum.whole);
    if (dz >= -1 && dz <= 1 && plane.inner.count > 0)
      addAlong(plane.inner, dz, sum.inner);
  }
  return sum;
}

WindowSum
WindowSums::Cursor::sumPlane(std::int32_t z)
{
  const std::vector<VoxelKey>& keys = sums_.keys_;
  WindowSum sum;
  std::size_t row = 0;
  for (int dx = -2; dx <= 2; ++dx)
    for (int dy = -2; dy <= 2; ++dy) {
      std::size_t& next = rows_[row++];
      const VoxelKey key = voxelKey({place_[0] + dx, place_[1] + dy, z});
      while (next < keys.size() && keys[next] < key)
        ++next;
      if (next == keys.size() || keys[next] != key)
        continue;
      const bool is_inner = dx >= -1 && dx <= 1 && dy >= -1 && dy <= 1;
      addAcross(sums_.moments_[next], dx, dy, is_inner ? sum.inner : sum.whole);
    }
  sum.whole += sum.inner;
  return sum;
}

} // namespace pcl::acmap
