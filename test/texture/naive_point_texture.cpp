#include "naive_point_texture.h"

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

/** Crossings of a ray along texel_u with a loop. */
int
crossings(const TextureChart& chart,
          const std::vector<Eigen::Vector3f>& loop,
          const Eigen::Vector2d& place)
{
  const auto flat = [&](const Eigen::Vector3f& corner) -> Eigen::Vector2d {
    const Eigen::Vector3d way = corner.cast<double>() - chart.origin;
    return Eigen::Vector2d(way.dot(chart.texel_u), way.dot(chart.texel_v)) /
           chart.texel_u.squaredNorm();
  };
  int count = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Eigen::Vector2d a = flat(loop[k]), b = flat(loop[(k + 1) % loop.size()]);
    if ((a.y() <= place.y()) == (b.y() <= place.y()))
      continue;
    const double share = (place.y() - a.y()) / (b.y() - a.y());
    count += a.x() + share * (b.x() - a.x()) > place.x() ? 1 : 0;
  }
  return count;
}

/** The texel of a position in space, or -1 if it is not in the polygon. */
int
texelOf(const CompactMap& map, const TextureChart& chart, const Eigen::Vector3d& point)
{
  const Eigen::Vector3d way = point - chart.origin;
  const double size = chart.texel_u.squaredNorm();
  const double column = std::floor(way.dot(chart.texel_u) / size);
  const double row = std::floor(way.dot(chart.texel_v) / size);
  if (column < 0 || row < 0 || column >= chart.colors.width ||
      row >= chart.colors.height)
    return -1;
  const PlanePolygon& polygon = map.planes[chart.plane].polygons[chart.polygon];
  const Eigen::Vector2d middle(column + 0.5, row + 0.5);
  int count = crossings(chart, polygon.outer, middle);
  for (const std::vector<Eigen::Vector3f>& hole : polygon.holes)
    count += crossings(chart, hole, middle);
  return count % 2 == 0 ? -1 : static_cast<int>(row * chart.colors.width + column);
}

} // namespace

NaivePointTexture
textureNaively(const CompactMap& map,
               const std::vector<View>& views,
               double maximum_distance)
{
  NaivePointTexture texture;
  for (const TextureChart& chart : map.charts)
    texture.charts.emplace_back(chart.kinds.size());
  for (const View& view : views)
    for (const PointXYZRGB& seen : *view.cloud) {
      const Eigen::Vector3d point =
          view.T_map_camera * seen.getVector3fMap().cast<double>();
      if (!point.allFinite())
        continue;
      double closest = maximum_distance;
      NaiveTexel* texel = nullptr;
      for (std::size_t c = 0; c < map.charts.size(); ++c) {
        const Eigen::Vector4d& plane = map.planes[map.charts[c].plane].coefficients;
        const double distance = std::abs(plane.dot(point.homogeneous()));
        const int place = texelOf(map, map.charts[c], point);
        if (distance >= closest || place < 0)
          continue;
        closest = distance;
        texel = &texture.charts[c][static_cast<std::size_t>(place)];
      }
      ++(texel ? texture.colored_points : texture.far_points);
      if (!texel)
        continue;
      ++texel->points;
      const Rgb color = {double(seen.r), double(seen.g), double(seen.b)};
      for (std::size_t k = 0; k < 3; ++k)
        texel->mean[k] += (color[k] - texel->mean[k]) / texel->points;
    }
  return texture;
}

} // namespace pcl::acmap::test
