#pragma once

#include <pcl/core/report.h>

#include <cstddef>
#include <vector>

namespace pcl {

/** \brief What PlaneTexturing tells about its last run. \ingroup texture */
struct TexturingReport : Report {
  std::size_t observations = 0; ///< that were given
  std::size_t pinholes =
      0; ///< of them organized, as a pinhole camera sees: projected into
  std::size_t splatted = 0;  ///< of them others: each point colours the texel it is in
  std::size_t colorless = 0; ///< of them without colour; their texels stay unknown
  std::size_t invalid_points = 0; ///< of all observations, not finite
  std::size_t charts = 0;
  std::size_t texels = 0; ///< inside the polygons
  std::size_t seen = 0;   ///< of them coloured by observations
  std::size_t filled = 0; ///< of them coloured after neighbours
  double texel_size = 0;  ///< metres
  std::vector<double>
      gains; ///< by which the colours of each observation were multiplied
};

} // namespace pcl
