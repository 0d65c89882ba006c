#include "labeling/survey.h"

#include <pcl/core/impl/parallel.h>

namespace pcl::acmap::labeling {

Survey::Survey(const PointView& points,
               const SensorView& sensors,
               const CandidateGrid& grid)
: points_(points)
, sensors_(sensors)
, entries_(points.size(), -1)
{
  parallelForChunks(points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      VoxelHit hit;
      if (grid.lattice().locate(points[i], hit))
        entries_[i] = grid.find(voxelKey(hit.place));
    }
  });
}

Survey
Survey::thinned(std::size_t maximum, const CandidateGrid& grid) const
{
  std::vector<std::size_t> counts(grid.size(), 0);
  for (const std::int32_t entry : entries_)
    if (entry >= 0)
      ++counts[static_cast<std::size_t>(entry)];
  Survey few(points_, sensors_);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i] < 0)
      continue;
    // A hash is used because every n-th point could be one column of the view.
    const std::size_t step =
        counts[static_cast<std::size_t>(entries_[i])] / maximum + 1;
    if ((i * 0x9e3779b97f4a7c15u >> 32) % step != 0)
      continue;
    few.entries_.push_back(entries_[i]);
    few.places_.push_back(i);
    few.counts_.push_back(step);
  }
  return few;
}

} // namespace pcl::acmap::labeling
