#pragma once

#include "texturing/chart_frame.h"

#include <pcl/core/compact_map.h>

#include <array>
#include <vector>

namespace pcl::acmap::texturing {

/** Which texels of a chart belong to its polygon. */
enum class TexelPlace : std::uint8_t {
  Outside = 0,
  Rim = 1,   ///< next to an inner texel; interpolation at the polygon's edge needs its
             ///< colour
  Inside = 2 ///< its centre is inside
};

/** One value per texel, in row-major order from the top. */
std::vector<TexelPlace>
maskOf(const TextureChart& chart, const PlanePolygon& polygon);

/** Sample of a texel in one view. */
struct Sample {
  float weight = 0; ///< 0 if there is no sample
  std::int32_t view = -1;
  std::array<std::uint8_t, 3> color{};
};

/** A chart during texturing. */
struct Canvas {
  static constexpr std::size_t max_samples = 4;
  using Samples = std::array<Sample, max_samples>;

  TextureChart chart; ///< without colours yet
  std::vector<TexelPlace> mask;
  std::vector<Samples> samples; ///< best first

  std::size_t
  index(std::int32_t column, std::int32_t row) const
  {
    return static_cast<std::size_t>(row) *
               static_cast<std::size_t>(chart.colors.width) +
           static_cast<std::size_t>(column);
  }

  bool
  holds(const Eigen::Vector2d& place) const
  {
    return place.x() >= 0 && place.y() >= 0 && place.x() < chart.colors.width &&
           place.y() < chart.colors.height &&
           mask[index(static_cast<std::int32_t>(place.x()),
                      static_cast<std::int32_t>(place.y()))] != TexelPlace::Outside;
  }

  /** Keeps the sample if it is among the best ones of its texel. */
  void
  offer(std::size_t texel, Sample sample)
  {
    for (Sample& kept : samples[texel])
      if (sample.weight > kept.weight)
        std::swap(sample, kept);
  }
};

/** The canvases of the polygons, in the order of the planes.
 * \param[in,out] left_out is increased by the number of polygons that cannot have a
 * canvas
 * \throws BadArgumentException when they have more than 2^28 texels */
std::vector<Canvas>
canvasesOf(const std::vector<PlanePatch>& planes,
           double texel_size,
           int most,
           std::size_t& left_out);

/** Memory in bytes of the canvases and their charts. */
double
canvasBytes(const std::vector<PlanePatch>& planes, double texel_size);

} // namespace pcl::acmap::texturing
