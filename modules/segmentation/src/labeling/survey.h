#pragma once

#include "labeling/candidate_grid.h"
#include "labeling/sight.h"

namespace pcl::acmap::labeling {

/** The points to be labelled, each with its entry in the grid of near planes, which is
 * looked up once. */
class Survey {
public:
  Survey(const PointView& points, const SensorView& sensors, const CandidateGrid& grid);

  /** A sample of about \a maximum points of each voxel at most. Each point represents
   * several ones, see count. */
  Survey
  thinned(std::size_t maximum, const CandidateGrid& grid) const;

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

  [[gnu::always_inline]] Sight
  sight(std::size_t i) const
  {
    return Sight(points_[place(i)], sensors_[place(i)]);
  }

  /** Number of the observation of the point, -1 if unknown. */
  std::int32_t
  observation(std::size_t i) const
  {
    return sensors_.observation(place(i));
  }

  /** Number of points that this point represents. */
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
  LargeVector<std::int32_t> entries_;
  LargeVector<std::uint32_t> places_; ///< indices of the points; empty for all of them
  LargeVector<std::uint32_t> counts_; ///< represented points; empty for one each
};

} // namespace pcl::acmap::labeling
