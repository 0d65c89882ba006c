#include "labeling/survey.h"

#include <pcl/core/impl/large_memory.h>
#include <pcl/core/impl/parallel.h>

#include <algorithm>

namespace pcl::acmap::labeling {

Survey::Survey(const PointView& points,
               const SensorView& sensors,
               const CandidateGrid& grid)
: points_(points)
, sensors_(sensors)
{
  assignLarge(entries_, points.size(), std::int32_t{-1});
  parallelForChunks(points.size(), [&](std::size_t begin, std::size_t end) {
    VoxelHit hit;
    VoxelKey last = 0;
    std::int32_t entry = grid.find(last);
    for (std::size_t i = begin; i < end; ++i) {
      if (!grid.lattice().locate(points[i], hit))
        continue;
      const VoxelKey key = voxelKey(hit.place);
      if (key != last) { // neighbours in an image are often in one voxel
        last = key;
        entry = grid.find(key);
      }
      entries_[i] = entry;
    }
  });
}

Survey
Survey::thinned(std::size_t maximum, const CandidateGrid& grid) const
{
  std::vector<std::uint32_t> steps(grid.size(), 0);
  for (const std::int32_t entry : entries_)
    if (entry >= 0)
      ++steps[static_cast<std::size_t>(entry)];
  for (std::uint32_t& step : steps)
    step = static_cast<std::uint32_t>(step / maximum + 1);
  // A hash is used because every n-th point could be one column of the view.
  const auto isChosen = [&](std::size_t i) {
    return entries_[i] >= 0 &&
           static_cast<std::uint32_t>(i * 0x9e3779b97f4a7c15u >> 32) %
                   steps[static_cast<std::size_t>(entries_[i])] ==
               0;
  };
  constexpr std::size_t part = 65536;
  std::vector<std::vector<std::uint32_t>> chosen((entries_.size() + part - 1) / part);
  oneapi::tbb::parallel_for(std::size_t{0}, chosen.size(), [&](std::size_t p) {
    const std::size_t end = std::min((p + 1) * part, entries_.size());
    for (std::size_t i = p * part; i < end; ++i)
      if (isChosen(i))
        chosen[p].push_back(static_cast<std::uint32_t>(i));
    pollRun();
  });
  Survey few(points_, sensors_);
  for (const std::vector<std::uint32_t>& places : chosen)
    few.places_.insert(few.places_.end(), places.begin(), places.end());
  few.entries_.reserve(few.places_.size());
  few.counts_.reserve(few.places_.size());
  for (const std::uint32_t place : few.places_) {
    few.entries_.push_back(entries_[place]);
    few.counts_.push_back(steps[static_cast<std::size_t>(entries_[place])]);
  }
  return few;
}

} // namespace pcl::acmap::labeling
