#include "map_raycast.h"

#include <pcl/simulation/ray_casting.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::bench {
namespace {

/** Intersection of a ray with a chart, in texels; NaN if there is none. */
struct ChartHit {
  double distance = std::numeric_limits<double>::infinity();
  Eigen::Vector2d texel;
};

ChartHit
meet(const TextureChart& chart, const Eigen::Vector3d& eye, const Eigen::Vector3d& ray)
{
  const Eigen::Vector3d normal = chart.texel_v.cross(chart.texel_u);
  const double along = normal.dot(ray);
  ChartHit meeting;
  if (!(along < 0)) // the back side
    return meeting;
  const double distance = normal.dot(chart.origin - eye) / along;
  if (!(distance > 0))
    return meeting;
  const Eigen::Vector3d way = eye + distance * ray - chart.origin;
  meeting.texel = {way.dot(chart.texel_u) / chart.texel_u.squaredNorm(),
                   way.dot(chart.texel_v) / chart.texel_v.squaredNorm()};
  const auto column = static_cast<std::int64_t>(std::floor(meeting.texel.x()));
  const auto row = static_cast<std::int64_t>(std::floor(meeting.texel.y()));
  if (column < 0 || row < 0 || column >= chart.colors.width ||
      row >= chart.colors.height)
    return meeting;
  if (chart.kinds[static_cast<std::size_t>(row * chart.colors.width + column)] !=
      TexelKind::None)
    meeting.distance = distance;
  return meeting;
}

/** Bilinear interpolation between the centres of four texels. */
Eigen::Vector3d
colorAt(const TextureChart& chart, const Eigen::Vector2d& texel)
{
  const Eigen::Vector2d place = texel.array() - 0.5;
  const Eigen::Vector2d corner = place.array().floor();
  const Eigen::Vector2d share = place - corner;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int r = 0; r < 2; ++r)
    for (int c = 0; c < 2; ++c) {
      const int column =
          std::clamp(static_cast<int>(corner.x()) + c, 0, chart.colors.width - 1);
      const int row =
          std::clamp(static_cast<int>(corner.y()) + r, 0, chart.colors.height - 1);
      const std::uint8_t* color = chart.colors.at(column, row);
      sum += (c ? share.x() : 1 - share.x()) * (r ? share.y() : 1 - share.y()) *
             Eigen::Vector3d(color[0], color[1], color[2]);
    }
  return sum;
}

} // namespace

RaycastImage
castMap(const CompactMap& map,
        const TrinocularRig& rig,
        const Eigen::Isometry3d& T_map_camera)
{
  RaycastImage view;
  const Eigen::Vector3d eye = T_map_camera.translation();
  for (int row = 0; row < rig.height; ++row)
    for (int column = 0; column < rig.width; ++column) {
      const Eigen::Vector3d ray = T_map_camera.linear() * pixelRay(rig, column, row);
      ChartHit nearest;
      const TextureChart* hit = nullptr;
      for (const TextureChart& chart : map.charts) {
        const ChartHit next = meet(chart, eye, ray);
        if (next.distance < nearest.distance) {
          nearest = next;
          hit = &chart;
        }
      }
      view.is_known.push_back(hit ? 1 : 0);
      const Eigen::Vector3d color =
          hit ? colorAt(*hit, nearest.texel) : Eigen::Vector3d::Zero();
      for (int k = 0; k < 3; ++k)
        view.rgb.push_back(static_cast<std::uint8_t>(std::lround(color[k])));
    }
  return view;
}

} // namespace pcl::acmap::bench
