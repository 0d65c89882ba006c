#include "revisits/depth_agreement.h"

#include <pcl/core/pinhole.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::acmap {

namespace {

/** How the depth of a point lies to those that were measured around its pixel. */
enum class DepthOrder { Unknown, Same, Before, Behind };

DepthOrder
orderOf(const Eigen::Vector3d& point,
        double sigma,
        const Eigen::Vector2d& pixel,
        const CameraView& view)
{
  constexpr int reach = 2;               // pixels: holes and slanted surfaces
  constexpr double max_deviations = 3;   // standard deviations
  constexpr double min_tolerance = 0.02; // of the depth
  const auto column = static_cast<int>(std::lround(pixel.x()));
  const auto row = static_cast<int>(std::lround(pixel.y()));
  bool is_before = false, is_behind = false;
  for (int y = std::max(row - reach, 0);
       y <= std::min(row + reach, view.image.height - 1);
       ++y)
    for (int x = std::max(column - reach, 0);
         x <= std::min(column + reach, view.image.width - 1);
         ++x) {
      const auto place = static_cast<std::size_t>(y * view.image.width + x);
      const double depth = view.points[place].z();
      if (!(depth > 0) || !std::isfinite(depth))
        continue;
      const double tolerance =
          std::max(min_tolerance * depth,
                   max_deviations * std::hypot(sigma, double{view.sigmas[place]}));
      if (std::abs(point.z() - depth) <= tolerance)
        return DepthOrder::Same;
      (point.z() < depth ? is_before : is_behind) = true;
    }
  if (is_before == is_behind)
    return DepthOrder::Unknown; // nothing was measured there, or an edge
  return is_before ? DepthOrder::Before : DepthOrder::Behind;
}

DepthAgreement
agreementOf(const CameraView& view,
            const CameraView& other,
            const Eigen::Isometry3d& T_other_view)
{
  constexpr int every = 4; // pixels
  DepthAgreement agreement;
  const auto pinhole = fitUprightPinhole(
      {other.points.data(), sizeof other.points[0], other.points.size()},
      static_cast<std::size_t>(other.image.width));
  if (!pinhole)
    return agreement;
  std::size_t points = 0, same = 0, before = 0;
  for (int row = 0; row < view.image.height; row += every)
    for (int column = 0; column < view.image.width; column += every) {
      const auto place = static_cast<std::size_t>(row * view.image.width + column);
      if (!view.points[place].allFinite() || !(view.points[place].z() > 0))
        continue;
      ++points;
      const Eigen::Vector3d there = T_other_view * view.points[place].cast<double>();
      if (!(there.z() > 0))
        continue;
      const Eigen::Vector2d pixel = pinhole->project(there);
      if (!(pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < other.image.width &&
            pixel.y() < other.image.height))
        continue;
      const DepthOrder order = orderOf(there, view.sigmas[place], pixel, other);
      same += order == DepthOrder::Same;
      before += order == DepthOrder::Before;
    }
  if (points > 0)
    agreement.overlap = static_cast<double>(same) / static_cast<double>(points);
  if (same + before > 0)
    agreement.contradicted =
        static_cast<double>(before) / static_cast<double>(same + before);
  return agreement;
}

} // namespace

DepthAgreement
compareDepths(const CameraView& source,
              const CameraView& target,
              const Eigen::Isometry3d& T_target_source)
{
  const DepthAgreement there = agreementOf(source, target, T_target_source);
  const DepthAgreement back = agreementOf(target, source, T_target_source.inverse());
  return {std::min(there.overlap, back.overlap),
          std::max(there.contradicted, back.contradicted)};
}

} // namespace pcl::acmap
