#pragma once

#include "texturing/canvas.h"

#include <pcl/core/pinhole.h>
#include <pcl/texture/impl/texturing_kernel.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace pcl::acmap::texturing {

/** For each point of a view, the canvas that it colours, or -1: the canvas of the
 * closest plane or cylinder that faces the sensor and whose polygon contains the
 * projection of the point (the last step of the paper).
 * \param[in] outermost texels in which the projection may be */
PointLabels
nearestCanvases(const ColoredView& view,
                const std::vector<Canvas>& canvases,
                double maximum_distance,
                TexelPlace outermost);

/** Offers the colours of a pinhole view to the texels that it sees.
 *
 * A texel is visible if the depth around its pixel belongs to its plane only; it is
 * not visible at depth edges. Frontal and near views get larger weights than others
 * (by the area of a pixel on the plane), and the centre of an image gets larger
 * weights than its border, so that views blend into each other.
 * \param[in] nearest canvas of each pixel, from \ref nearestCanvases */
void
paintPinhole(const ColoredView& view,
             const Pinhole& camera,
             std::int32_t number,
             const PointLabels& nearest,
             std::vector<Canvas>& canvases);

/** Unpacks the colour of a point of a view. */
inline std::array<std::uint8_t, 3>
colorOf(const ColoredView& view, std::size_t i)
{
  std::uint32_t packed;
  const auto place = static_cast<std::size_t>(view.points.index(i));
  std::memcpy(&packed,
              static_cast<const char*>(view.colors.first) + view.colors.stride * place,
              sizeof packed);
  return {static_cast<std::uint8_t>(packed >> 16),
          static_cast<std::uint8_t>(packed >> 8),
          static_cast<std::uint8_t>(packed)};
}

/** The stations from which a merged cloud was seen: a single one if it does not say. */
class Stations {
public:
  Stations() = default;

  explicit Stations(const ColoredView& view);

  std::size_t
  count() const
  {
    return std::max<std::size_t>(numbers_.size(), 1);
  }

  /** Which of them saw a point. */
  std::int32_t
  indexOf(const ColoredView& view, std::size_t point) const;

private:
  static std::int32_t
  stationOf(const ColoredView& view, std::size_t point);

  std::vector<std::int32_t> numbers_; ///< ascending; empty if there is one
};

/** Colours each texel with the robust middle of the points that are nearest to it, of each
 * station alone; for clouds whose camera is unknown.
 * \param[in] number of the view of the first station */
void
splat(const ColoredView& view,
      std::int32_t number,
      const Stations& stations,
      const PointLabels& nearest,
      std::vector<Canvas>& canvases);

/** Adds the colours of the points to the texels in which they are, and nothing else; for
 * the paper mode. */
void
addPoints(const ColoredView& view,
          std::int32_t number,
          const PointLabels& nearest,
          std::vector<Canvas>& canvases);

/** Exposure gains, one per view, for which the views agree on the texels that they
 * share: the least-squares solution in the logarithms of the brightness, with a prior
 * that keeps the gains near 1; views without shared texels get 1. Clipped samples are
 * ignored. */
std::vector<double>
exposureGains(const std::vector<Canvas>& canvases, std::size_t views);

/** CompactMap::exposure for the charts and cylinders of a map: 95 % of the known texels get a luminance of at
 * most 0.85, and at most 1 % of them are clipped; from 1 to 16. */
double
displayExposure(const CompactMap& map);

/** Colours the picture of a canvas. The samples of each texel are brought to a common
 * exposure; the colour is the mean of those that agree with the weighted median. So an
 * object that is visible in one view only leaves no trace where other views saw the
 * wall. */
void
blend(const std::vector<double>& gains, const Canvas& canvas, TexturePicture& picture);

/** Colours each texel with the mean of its points. */
void
average(const Canvas& canvas, TexturePicture& picture);

/** Colours texels without a sample from their neighbours, ring by ring from the border
 * of the observed texels: at most \a distance texels, and the rim of the polygon one
 * texel further. */
void
fillHoles(int distance, const LargeVector<TexelPlace>& mask, TexturePicture& picture);

} // namespace pcl::acmap::texturing
