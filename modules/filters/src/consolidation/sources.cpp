#include "consolidation/sources.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

PointLabels
representativesOfCells(const VoxelWindows& windows,
                       const LargeVector<Candidate>& candidates,
                       const Thinning& thinning)
{
  const auto& cells = windows.voxels().cells;
  PointLabels of_cell(cells.size());
  parallelForChunks(windows.size(), [&](std::size_t begin, std::size_t end) {
    auto first = static_cast<std::size_t>(
        std::lower_bound(candidates.begin(),
                         candidates.end(),
                         begin,
                         [](const Candidate& candidate, std::size_t voxel) {
                           return candidate.voxel < voxel;
                         }) -
        candidates.begin());
    for (std::size_t v = begin; v < end; ++v) {
      std::size_t last = first;
      while (last < candidates.size() && candidates[last].voxel == v)
        ++last;
      for (std::size_t c = windows.firstCell(v); c < windows.firstCell(v + 1); ++c) {
        of_cell[c] = thinning.stand_in[first];
        for (std::size_t k = first; k < last; ++k)
          if (candidates[k].octants >> octantOf(cells[c].key) & 1)
            of_cell[c] = thinning.stand_in[k];
      }
      first = last;
    }
  });
  return of_cell;
}

void
setMeanColors(const VoxelMoments& voxels,
              const PointLabels& of_cell,
              LargeVector<Representative>& representatives)
{
  if (voxels.colors.empty())
    return;
  LargeVector<ColorSum> sums(representatives.size());
  LargeVector<double> counts(representatives.size());
  for (std::size_t c = 0; c < voxels.colors.size(); ++c) {
    const auto r = static_cast<std::size_t>(of_cell[c]);
    sums[r].red += voxels.colors[c].red;
    sums[r].green += voxels.colors[c].green;
    sums[r].blue += voxels.colors[c].blue;
    counts[r] += voxels.cells[c].moments.count;
  }
  parallelForChunks(representatives.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      const auto mean = [&](std::uint64_t sum) {
        return static_cast<std::uint8_t>(
            std::lround(static_cast<double>(sum) / counts[r]));
      };
      representatives[r].color = {
          mean(sums[r].red), mean(sums[r].green), mean(sums[r].blue)};
    }
  });
}

PointLabels
representativesOf(const PointView& points,
                  const SensorView& sensors,
                  const VoxelMoments& voxels,
                  const PointLabels& of_cell)
{
  const auto& cells = voxels.cells;
  const VoxelLattice& lattice = voxels.lattice;
  PointLabels result(points.size(), -1);
  parallelForChunks(points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      VoxelHit hit;
      const Eigen::Vector3f point = points[i];
      if (!lattice.locate(point, hit))
        continue;
      const Eigen::Vector3f* sensor = sensors[i];
      const VoxelKey key =
          voxelKey(hit.place, sensor ? octantTowards(point, *sensor) : 0);
      const auto cell = std::lower_bound(
          cells.begin(), cells.end(), key, [](const VoxelCell& c, VoxelKey minimum) {
            return c.key < minimum;
          });
      result[i] = of_cell[static_cast<std::size_t>(cell - cells.begin())];
    }
  });
  return result;
}

} // namespace pcl::acmap
