#include "texturing/canvas_painting.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/texture/impl/texturing_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace pcl::acmap::texturing {

namespace {

using Rgb = std::array<std::uint8_t, 3>;

/** Unpacks the colour of a point of a view. */
Rgb
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

/** Textures one canvas with one view. */
class Painter {
public:
  Painter(const ColoredView& view,
          const Pinhole& camera,
          std::int32_t number,
          const std::vector<std::int32_t>& nearest,
          Canvas& canvas)
  : view_(view)
  , camera_(camera)
  , number_(number)
  , nearest_(nearest)
  , canvas_(canvas)
  , height_(static_cast<int>(view.points.size()) / view.width)
  , T_camera_map_(view.T_map_camera.inverse())
  {}

  void
  paintRow(std::int32_t row)
  {
    const TextureChart& chart = canvas_.chart;
    for (std::int32_t column = 0; column < chart.colors.width; ++column) {
      const std::size_t texel = canvas_.index(column, row);
      if (canvas_.mask[texel] != TexelPlace::Inside)
        continue;
      const Eigen::Vector3d middle = canvas_.surface.middleOf(column, row);
      const Eigen::Vector3d point = T_camera_map_ * middle;
      if (!(point.z() > min_depth) ||
          !canvas_.surface.faces(view_.T_map_camera.translation(), middle))
        continue;
      const Eigen::Vector2d pixel = camera_.project(point);
      if (!isInside(pixel))
        continue;
      const double visible = visibility(pixel);
      if (visible > 0)
        canvas_.offer(texel,
                      {static_cast<float>(visible * quality(middle, point, pixel)),
                       number_,
                       meanColor(column, row, point)});
    }
  }

private:
  static constexpr double min_depth = 0.05; // metres

  bool
  isInside(const Eigen::Vector2d& pixel) const
  {
    return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() <= view_.width - 1 &&
           pixel.y() <= height_ - 1;
  }

  std::size_t
  pixelAt(int column, int row) const
  {
    const int c = std::clamp(column, 0, view_.width - 1);
    const int r = std::clamp(row, 0, height_ - 1);
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(view_.width) +
           static_cast<std::size_t>(c);
  }

  /** 1 if the depth around a pixel belongs to this plane, less if the nearest depth is
   * farther away; 0 at depth edges and where the depth belongs to something else: such
   * texels are better filled from the inside. */
  double
  visibility(const Eigen::Vector2d& pixel) const
  {
    constexpr double unmeasured = 0.3;
    const int column = static_cast<int>(std::lround(pixel.x()));
    const int row = static_cast<int>(std::lround(pixel.y()));
    for (const int reach : {2, 4}) {
      int own = 0, others = 0;
      for (int r = -reach; r <= reach; r += reach)
        for (int c = -reach; c <= reach; c += reach)
          count(pixelAt(column + c, row + r), own, others);
      if (others > 0)
        return 0;
      if (own > 0)
        return reach > 2 ? unmeasured : 1;
    }
    return 0;
  }

  void
  count(std::size_t pixel, int& own, int& others) const
  {
    if (nearest_[pixel] == static_cast<std::int32_t>(canvas_.number))
      ++own;
    else if (view_.points[pixel].allFinite())
      ++others;
  }

  /** Area of the texel in the image, up to a constant factor; reduced towards the image
   * border. */
  double
  quality(const Eigen::Vector3d& middle,
          const Eigen::Vector3d& point,
          const Eigen::Vector2d& pixel) const
  {
    const Eigen::Vector3d ray = middle - view_.T_map_camera.translation();
    const double range = ray.norm();
    const double slant = std::abs(canvas_.surface.normalAt(middle).dot(ray)) / range;
    constexpr double fade = 0.1; // fraction of the image width
    const double from_rim = std::min(
        {pixel.x(), pixel.y(), view_.width - 1 - pixel.x(), height_ - 1 - pixel.y()});
    const double rim = std::clamp(from_rim / (fade * view_.width), 0.01, 1.0);
    return slant * rim / (point.z() * point.z());
  }

  /** Mean over the pixels of the texel, as a texel may cover several of them; ignores
   * pixels that see something else. */
  Rgb
  meanColor(std::int32_t column, std::int32_t row, const Eigen::Vector3d& point) const
  {
    const double texel = canvas_.surface.texelWidth();
    const double pixels = texel * camera_.fx / point.z();
    const int side = static_cast<int>(std::clamp(std::ceil(pixels), 1.0, 5.0));
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int count = 0;
    for (int v = 0; v < side; ++v)
      for (int u = 0; u < side; ++u) {
        const Eigen::Vector3d place =
            T_camera_map_ * canvas_.surface.middleOf(column + (u + 0.5) / side - 0.5,
                                                     row + (v + 0.5) / side - 0.5);
        const Eigen::Vector2d pixel = camera_.project(place);
        if (!(place.z() > min_depth) || !isInside(pixel) || seesOthers(pixel))
          continue;
        sum += interpolated(pixel);
        ++count;
      }
    if (count > 0)
      sum /= count;
    else
      sum = interpolated(camera_.project(point));
    Rgb color;
    for (int k = 0; k < 3; ++k)
      color[static_cast<std::size_t>(k)] =
          static_cast<std::uint8_t>(std::lround(sum[k]));
    return color;
  }

  /** Does one of the four pixels around a position see something else than this
   * plane? */
  bool
  seesOthers(const Eigen::Vector2d& pixel) const
  {
    int own = 0, others = 0;
    for (int r = 0; r < 2; ++r)
      for (int c = 0; c < 2; ++c)
        count(pixelAt(static_cast<int>(pixel.x()) + c, static_cast<int>(pixel.y()) + r),
              own,
              others);
    return others > 0;
  }

  Eigen::Vector3d
  interpolated(const Eigen::Vector2d& pixel) const
  {
    const double x = std::floor(pixel.x()), y = std::floor(pixel.y());
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int r = 0; r < 2; ++r)
      for (int c = 0; c < 2; ++c) {
        const double share = (c ? pixel.x() - x : 1 - (pixel.x() - x)) *
                             (r ? pixel.y() - y : 1 - (pixel.y() - y));
        const Rgb color =
            colorOf(view_, pixelAt(static_cast<int>(x) + c, static_cast<int>(y) + r));
        sum += share * Eigen::Vector3d(color[0], color[1], color[2]);
      }
    return sum;
  }

  const ColoredView& view_;
  const Pinhole& camera_;
  std::int32_t number_;
  const std::vector<std::int32_t>& nearest_;
  Canvas& canvas_;
  int height_; ///< pixels
  Eigen::Isometry3d T_camera_map_;
};

/** Indices of the points of one canvas, in ascending order. */
using Points = std::vector<std::size_t>;

void
splatOnto(const ColoredView& view,
          std::int32_t number,
          const Points& points,
          Canvas& canvas)
{
  std::vector<PointColors> sums(canvas.mask.size());
  for (const std::size_t i : points) {
    const Eigen::Vector2d place =
        canvas.surface.placeOf(view.T_map_camera * view.points[i].cast<double>());
    const std::size_t texel = canvas.texelAt(place);
    if (canvas.mask[texel] == TexelPlace::Inside)
      sums[texel].add(colorOf(view, i));
  }
  for (std::size_t t = 0; t < sums.size(); ++t)
    if (sums[t].count > 0)
      canvas.offer(t, {static_cast<float>(sums[t].count), number, sums[t].mean()});
}

} // namespace

void
paintPinhole(const ColoredView& view,
             const Pinhole& camera,
             std::int32_t number,
             const std::vector<std::int32_t>& nearest,
             std::vector<Canvas>& canvases)
{
  // compares surfaces, not canvases, as a texel at the border of a tile has neighbours on
  // another tile
  std::vector<std::int32_t> nearest_surfaces(nearest.size(), -1);
  std::vector<bool> is_seen(canvases.empty() ? 0 : canvases.back().number + 1, false);
  for (std::size_t i = 0; i < nearest.size(); ++i)
    if (nearest[i] >= 0) {
      const std::size_t surface = canvases[static_cast<std::size_t>(nearest[i])].number;
      nearest_surfaces[i] = static_cast<std::int32_t>(surface);
      is_seen[surface] = true;
    }
  for (Canvas& canvas : canvases) {
    if (!is_seen[canvas.number])
      continue;
    Painter painter(view, camera, number, nearest_surfaces, canvas);
    oneapi::tbb::parallel_for(std::int32_t{0},
                              canvas.chart.colors.height,
                              [&](std::int32_t row) { painter.paintRow(row); });
  }
}

void
splat(const ColoredView& view,
      std::int32_t number,
      const std::vector<std::int32_t>& nearest,
      std::vector<Canvas>& canvases)
{
  std::vector<Points> points(canvases.size());
  for (std::size_t i = 0; i < nearest.size(); ++i)
    if (nearest[i] >= 0)
      points[static_cast<std::size_t>(nearest[i])].push_back(i);
  for (std::size_t c = 0; c < canvases.size(); ++c)
    if (!points[c].empty())
      splatOnto(view, number, points[c], canvases[c]);
}

void
addPoints(const ColoredView& view,
          std::int32_t number,
          const std::vector<std::int32_t>& nearest,
          std::vector<Canvas>& canvases)
{
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    if (nearest[i] < 0)
      continue;
    Canvas& canvas = canvases[static_cast<std::size_t>(nearest[i])];
    const Eigen::Vector3d point = view.T_map_camera * view.points[i].cast<double>();
    canvas.points[canvas.texelAt(canvas.surface.placeOf(point))].add(colorOf(view, i));
    if (canvas.views.empty() || canvas.views.back() != number)
      canvas.views.push_back(number);
  }
}

} // namespace pcl::acmap::texturing
