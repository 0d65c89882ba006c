#pragma once

#include "labeling/candidate_grid.h"
#include "labeling/sight.h"

namespace pcl::acmap::labeling {

/** The points that are to be labelled, each with the planes near it: looked up once. */
class Survey {
public:
  Survey(const PointView& points, const SensorView& sensors, const CandidateGrid& grid);

  std::size_t
  size() const
  {
    return entries_.size();
  }

  /** Number of the point's entry in the grid, -1 where no plane is near. */
  std::int32_t
  entry(std::size_t i) const
  {
    return entries_[i];
  }

  Sight
  sight(std::size_t i) const
  {
    return Sight(points_[i], sensors_[i]);
  }

private:
  const PointView& points_;
  const SensorView& sensors_;
  std::vector<std::int32_t> entries_;
};

} // namespace pcl::acmap::labeling
