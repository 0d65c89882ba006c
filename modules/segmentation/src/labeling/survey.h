#pragma once

#include "labeling/candidate_grid.h"
#include "labeling/sight.h"

namespace pcl::acmap::labeling {

/** The points that are to be labelled, each with the planes near it: looked up once. */
class Survey {
public:
  Survey(const PointView& points, const SensorView& sensors, const CandidateGrid& grid);

  /** At most about so many points of each voxel, enough to judge by; each stands for as many
   * as were left out. */
  Survey
  thinned(std::size_t most, const CandidateGrid& grid) const;

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
    return Sight(points_[place(i)], sensors_[place(i)]);
  }

  /** Number of the observation that saw the point, -1 where unknown. */
  std::int32_t
  observation(std::size_t i) const
  {
    return sensors_.observation(place(i));
  }

  /** How many points it stands for. */
  std::size_t
  count(std::size_t i) const
  {
    return counts_.empty() ? 1 : counts_[i];
  }

private:
  Survey(const PointView& points, const SensorView& sensors)
  : points_(points)
  , sensors_(sensors)
  {}

  std::size_t
  place(std::size_t i) const
  {
    return places_.empty() ? i : places_[i];
  }

  const PointView& points_;
  const SensorView& sensors_;
  std::vector<std::int32_t> entries_;
  std::vector<std::size_t> places_; ///< of the points, empty for all of them
  std::vector<std::size_t> counts_; ///< of points they stand for, empty for one each
};

} // namespace pcl::acmap::labeling
