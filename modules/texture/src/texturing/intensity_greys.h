#pragma once

#include <pcl/core/scratch_memory.h>
#include <pcl/texture/impl/texturing_kernel.h>

#include <optional>

namespace pcl::acmap::texturing {

/** \brief Turns intensities, whose unit and range depend on the sensor, into greys. The
 * first view decides the scale: 0, or the 1st percentile if there are negative values,
 * becomes black, and the 99th percentile 230 of 255. */
class IntensityGreys {
public:
  /** \param[in] count number of points
   * \return packed colours; values that are not finite are black */
  LargeVector<std::uint32_t>
  packed(const IntensityView& intensities, std::size_t count);

private:
  struct Scale {
    double black, factor;
  };

  static Scale
  scaleOf(LargeVector<double> values);

  std::optional<Scale> scale_;
};

} // namespace pcl::acmap::texturing
