#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/sensor_view.h>

#include <cstddef>

namespace pcl::acmap {

/** \brief How far the observations of a merged cloud are from each other where they overlap.
 * \ingroup core */
struct ObservationGap {
  double radius = 0; ///< metres, within which points were compared
  double gap = 0;    ///< metres, root mean square distance; the median of the places
  std::size_t places = 0; ///< where several observations were compared

  /** \brief Is the gap that of surfaces which only happen to cross each other? */
  bool
  isChance() const
  {
    constexpr std::size_t enough = 50;
    constexpr double of_radius = 0.38; // evenly filled balls have 0.45
    return places >= enough && gap > of_radius * radius;
  }
};

/** \brief Compares the observations of a merged cloud at some 2,000 places: at each, a plane
 * is fitted to the points of one observation, and the points of the others around it have
 * their distances from that plane. Where the poses are right, they are those of noise.
 * \param[in] points the merged cloud, metres
 * \param[in] sensors names the observation of each point
 * \param[in] spacing side of the square of surface for each point, metres
 * \param[in] threads 0 for all; the result is the same
 * \return no places if \a spacing is not positive, or there are not several observations */
ACMAP_EXPORT ObservationGap
measureObservationGap(const PointView& points,
                      const SensorView& sensors,
                      double spacing,
                      unsigned threads = 0);

} // namespace pcl::acmap
