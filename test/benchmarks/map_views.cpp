#include "map_views.h"

#include "bench.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap::bench {
namespace {

constexpr std::size_t side = 8, stride = 4;

double
brightness(const std::vector<std::uint8_t>& image, std::size_t pixel)
{
  return 0.299 * image[3 * pixel] + 0.587 * image[3 * pixel + 1] +
         0.114 * image[3 * pixel + 2];
}

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

/** The nearest chart along a ray, if there is one. */
const TextureChart*
nearestChart(const CompactMap& map,
             const Eigen::Vector3d& eye,
             const Eigen::Vector3d& ray,
             ChartHit& nearest)
{
  const TextureChart* hit = nullptr;
  for (const TextureChart& chart : map.charts) {
    const ChartHit next = meet(chart, eye, ray);
    if (next.distance < nearest.distance) {
      nearest = next;
      hit = &chart;
    }
  }
  return hit;
}

} // namespace

MapView
castMap(const CompactMap& map,
        const ViewCamera& camera,
        const Eigen::Isometry3d& T_map_camera)
{
  const auto width = static_cast<std::size_t>(camera.width);
  MapView view;
  view.is_known.resize(width * static_cast<std::size_t>(camera.height));
  view.rgb.resize(3 * view.is_known.size());
  view.depth.resize(view.is_known.size());
  const Pinhole& pinhole = camera.pinhole;
  oneapi::tbb::parallel_for(std::size_t{0}, view.is_known.size(), [&](std::size_t i) {
    const Eigen::Vector3d in_camera(
        (static_cast<double>(i % width) - pinhole.cx) / pinhole.fx,
        (static_cast<double>(i / width) - pinhole.cy) / pinhole.fy,
        1);
    ChartHit nearest;
    const TextureChart* const hit = nearestChart(
        map, T_map_camera.translation(), T_map_camera.linear() * in_camera, nearest);
    if (!hit)
      return;
    view.is_known[i] = 1;
    view.depth[i] = static_cast<float>(nearest.distance);
    const Eigen::Vector3d color = colorAt(*hit, nearest.texel);
    for (std::size_t k = 0; k < 3; ++k)
      view.rgb[3 * i + k] =
          static_cast<std::uint8_t>(std::lround(color[static_cast<Eigen::Index>(k)]));
  });
  return view;
}

double
structuralSimilarity(const std::vector<std::uint8_t>& a,
                     const std::vector<std::uint8_t>& b,
                     const std::vector<std::uint8_t>& is_known,
                     std::size_t width)
{
  constexpr double count = side * side;
  constexpr double c1 = 0.01 * 255 * 0.01 * 255, c2 = 0.03 * 255 * 0.03 * 255;
  const std::size_t height = is_known.size() / width;
  std::vector<double> similarities;
  for (std::size_t top = 0; top + side <= height; top += stride)
    for (std::size_t left = 0; left + side <= width; left += stride) {
      Eigen::Vector2d sum(0, 0);
      Eigen::Matrix2d products = Eigen::Matrix2d::Zero();
      bool is_whole = true;
      for (std::size_t row = top; row < top + side && is_whole; ++row)
        for (std::size_t column = left; column < left + side; ++column) {
          const std::size_t pixel = row * width + column;
          is_whole = is_whole && is_known[pixel];
          const Eigen::Vector2d both(brightness(a, pixel), brightness(b, pixel));
          sum += both;
          products += both * both.transpose();
        }
      if (!is_whole)
        continue;
      const Eigen::Vector2d mean = sum / count;
      const Eigen::Matrix2d scatter = products / count - mean * mean.transpose();
      similarities.push_back((2 * mean.prod() + c1) * (2 * scatter(0, 1) + c2) /
                             ((mean.squaredNorm() + c1) * (scatter.trace() + c2)));
    }
  return meanOf(similarities);
}

} // namespace pcl::acmap::bench
