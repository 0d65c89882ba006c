#pragma once

#include "texturing/canvas_surface.h"

#include <pcl/core/compact_map.h>
#include <pcl/core/scratch_memory.h>

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
LargeVector<TexelPlace>
maskOf(const TextureChart& chart, const PlanePolygon& polygon);

/** Sample of a texel in one view. */
struct Sample {
  float weight = 0; ///< 0 if there is no sample
  std::int32_t view = -1;
  std::array<std::uint8_t, 3> color{};
};

/** The colours of some points, as their sum. */
struct PointColors {
  std::uint64_t count = 0;
  std::array<std::uint64_t, 3> sums{};

  void
  add(const std::array<std::uint8_t, 3>& color)
  {
    ++count;
    for (std::size_t k = 0; k < 3; ++k)
      sums[k] += color[k];
  }

  void
  add(const PointColors& other)
  {
    count += other.count;
    for (std::size_t k = 0; k < 3; ++k)
      sums[k] += other.sums[k];
  }

  /** The mean, rounded; not for a count of 0. */
  std::array<std::uint8_t, 3>
  mean() const
  {
    std::array<std::uint8_t, 3> color;
    for (std::size_t k = 0; k < 3; ++k)
      color[k] = static_cast<std::uint8_t>((sums[k] + count / 2) / count);
    return color;
  }
};

/** A chart or an unrolled cylinder during texturing. */
struct Canvas {
  static constexpr std::size_t max_samples = 4;
  using Samples = std::array<Sample, max_samples>;

  std::size_t number =
      0; ///< of its plane, or the number of planes plus that of the cylinder
  TextureChart chart; ///< without colours yet; of a cylinder only the size is set
  CanvasSurface surface;
  LargeVector<TexelPlace> mask;
  LargeVector<Samples> samples;    ///< of each texel, best first; not in paper mode
  LargeVector<PointColors> points; ///< in each texel; in paper mode only
  std::vector<std::int32_t> views; ///< in which these points are, ascending

  std::size_t
  index(std::int32_t column, std::int32_t row) const
  {
    return static_cast<std::size_t>(row) *
               static_cast<std::size_t>(chart.colors.width) +
           static_cast<std::size_t>(column);
  }

  /** Where a position in texels is relative to the polygon. */
  TexelPlace
  at(const Eigen::Vector2d& place) const
  {
    const bool is_on_chart = place.x() >= 0 && place.y() >= 0 &&
                             place.x() < chart.colors.width &&
                             place.y() < chart.colors.height;
    return is_on_chart ? mask[texelAt(place)] : TexelPlace::Outside;
  }

  /** The texel of a position on the chart. */
  std::size_t
  texelAt(const Eigen::Vector2d& place) const
  {
    return index(static_cast<std::int32_t>(place.x()),
                 static_cast<std::int32_t>(place.y()));
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

/** The edge of a texel in metres, one to \p max_enlargement times \p texel_size, of which these
 * surfaces have at most \p max_texels; \p texel_size if there is none. */
double
boundedTexelSize(const std::vector<PlanePatch>& planes,
                 const std::vector<CylinderPatch>& cylinders,
                 double texel_size,
                 double max_texels,
                 double max_enlargement);

/** The canvases of the polygons, in the order of the planes, then those of the cylinders,
 * without samples and points. A cylinder has one canvas, whose texels are enlarged if it
 * would have too many.
 * \param[in,out] left_out is increased by the number of polygons and cylinders that cannot
 * have a canvas
 * \throws BadArgumentException when they have more than 2^28 texels */
std::vector<Canvas>
canvasesOf(const std::vector<PlanePatch>& planes,
           const std::vector<CylinderPatch>& cylinders,
           double texel_size,
           int maximum,
           std::size_t& left_out);

/** Number of texels of the canvases. */
double
canvasTexels(const std::vector<PlanePatch>& planes,
             const std::vector<CylinderPatch>& cylinders,
             double texel_size);

} // namespace pcl::acmap::texturing
