#pragma once

#include "labeling/junctions.h"
#include "labeling/range_noise.h"

namespace pcl::acmap::labeling {

/** Decides to which plane a point belongs.
 *
 * The error of a sensor is along the ray, hardly across it. Therefore, where planes
 * meet, a point belongs to the plane that its ray intersects in front of the others (at
 * a concave edge) or behind them (at a convex edge). Only if there is no such plane is
 * the nearest one chosen. */
class RayLabels {
public:
  RayLabels(const CandidateGrid& grid,
            const RangeNoise& noise,
            const Junctions& junctions,
            const std::vector<KnownPlane>& planes)
  : grid_(grid)
  , noise_(noise)
  , junctions_(junctions)
  , planes_(planes)
  {}

  /** \return for each point its plane, -1 for none */
  PointLabels
  chooseAll(const Survey& survey) const;

private:
  std::int32_t
  choose(const Sight& sight, const Candidates& candidates) const;

  bool
  isInFront(const Eigen::Vector3d& foot,
            std::size_t own,
            const Candidates& candidates) const;

  const CandidateGrid& grid_;
  const RangeNoise& noise_;
  const Junctions& junctions_;
  const std::vector<KnownPlane>& planes_;
};

} // namespace pcl::acmap::labeling
