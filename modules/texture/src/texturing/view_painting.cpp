#include "texturing/canvas_painting.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/texture/impl/texturing_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace pcl::acmap::texturing {

namespace {

using Rgb = std::array<std::uint8_t, 3>;

/** What a pixel sees, if it is no surface of the map. */
constexpr std::int32_t something_else = -1, nothing = -2;

/** Pixels around a texel in which its surface is looked for. */
constexpr int near_reach = 2, far_reach = 4;

/** The pixels that see a surface are in this rectangle. */
using PixelBox = Eigen::AlignedBox<double, 2>;

/** \param[in] seen as \ref visibleSurfaces takes it
 * \return of each surface, with that border in which a texel may still be visible */
std::vector<PixelBox>
boxesOf(const std::vector<std::int32_t>& seen, int width, std::size_t surfaces)
{
  std::vector<PixelBox> boxes(surfaces);
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (seen[i] >= 0)
      boxes[static_cast<std::size_t>(seen[i])].extend(
          Eigen::Vector2d(static_cast<double>(i % static_cast<std::size_t>(width)),
                          static_cast<double>(i / static_cast<std::size_t>(width))));
  constexpr double border = far_reach + 1.5; // a half for rounding, 1 for its errors
  for (PixelBox& box : boxes)
    if (!box.isEmpty()) {
      box.min().array() -= border;
      box.max().array() += border;
    }
  return boxes;
}

/** The surface that a pixel shows, and how surely, 0 to 1. */
struct VisibleSurface {
  std::int32_t surface = nothing;
  float visible = 0;
};

/** The only surface that the pixels see at a distance around one; \ref nothing if they have no
 * depth, \ref something_else if there are several. */
std::int32_t
surfaceAround(
    const std::vector<std::int32_t>& seen, int width, int column, int row, int reach)
{
  const int height = static_cast<int>(seen.size()) / width;
  std::int32_t only = nothing;
  for (int r = row - reach; r <= row + reach; r += reach)
    for (int c = column - reach; c <= column + reach; c += reach) {
      const std::int32_t here = seen[static_cast<std::size_t>(
          std::clamp(r, 0, height - 1) * width + std::clamp(c, 0, width - 1))];
      if (here == nothing || here == only)
        continue;
      if (only != nothing || here == something_else)
        return something_else;
      only = here;
    }
  return only;
}

/** What the pixels show: a surface if the depth around a pixel belongs to it, less surely if the
 * nearest depth is farther away; none at depth edges and where the depth belongs to something
 * else: texels there are better filled from the inside.
 * \param[in] seen for each pixel the number of the surface that it sees, \ref something_else, or
 * \ref nothing if it has no depth */
std::vector<VisibleSurface>
visibleSurfaces(const std::vector<std::int32_t>& seen, int width)
{
  constexpr float unmeasured = 0.3F;
  std::vector<VisibleSurface> visible(seen.size());
  parallelForChunks(seen.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const int column = static_cast<int>(i) % width;
      const int row = static_cast<int>(i) / width;
      for (const int reach : {near_reach, far_reach}) {
        const std::int32_t surface = surfaceAround(seen, width, column, row, reach);
        if (surface >= 0)
          visible[i] = {surface, reach == far_reach ? unmeasured : 1};
        if (surface != nothing)
          break;
      }
    }
  });
  return visible;
}

/** Textures one canvas with one view. */
class Painter {
public:
  /** \param[in] seen, visible of each pixel (\ref visibleSurfaces)
   * \param[in] box of the pixels that may colour the canvas */
  Painter(const ColoredView& view,
          const Pinhole& camera,
          std::int32_t number,
          const std::vector<std::int32_t>& seen,
          const std::vector<VisibleSurface>& visible,
          const PixelBox& box,
          Canvas& canvas)
  : view_(view)
  , camera_(camera)
  , number_(number)
  , seen_(seen)
  , visible_(visible)
  , box_(box)
  , canvas_(canvas)
  , height_(static_cast<int>(view.points.size()) / view.width)
  , T_camera_map_(view.T_map_camera.inverse())
  , texel_width_(canvas.surface.texelWidth())
  {
    if (!isFlat())
      return;
    corner_ = T_camera_map_ * canvas.chart.origin;
    right_ = T_camera_map_.linear() * canvas.chart.texel_u;
    down_ = T_camera_map_.linear() * canvas.chart.texel_v;
    distance_ = canvas.surface.distance(view.T_map_camera.translation());
  }

  void
  paintRow(std::int32_t row)
  {
    const auto [first, end] = columnsInView(row);
    for (std::int32_t column = first; column < end; ++column) {
      const std::size_t texel = canvas_.index(column, row);
      if (canvas_.mask[texel] != TexelPlace::Inside)
        continue;
      const Eigen::Vector3d point = pointAt(column, row);
      if (!(point.z() > min_depth))
        continue;
      const Eigen::Vector2d pixel = camera_.project(point);
      if (!isInside(pixel))
        continue;
      const VisibleSurface& shown =
          visible_[pixelAt(static_cast<int>(std::lround(pixel.x())),
                           static_cast<int>(std::lround(pixel.y())))];
      if (shown.surface != static_cast<std::int32_t>(canvas_.number) ||
          !faces(column, row))
        continue;
      const auto weight = static_cast<float>(static_cast<double>(shown.visible) *
                                             quality(column, row, point, pixel));
      if (weight > canvas_.samples[texel].back().weight) // else it would not be kept
        canvas_.offer(texel, {weight, number_, meanColor(column, row, point, pixel)});
    }
  }

private:
  static constexpr double min_depth = 0.05; // metres

  bool
  isFlat() const
  {
    return canvas_.surface.plane() != nullptr;
  }

  /** Centre of a texel in the frame of the camera. */
  Eigen::Vector3d
  pointAt(double column, double row) const
  {
    return isFlat() ? Eigen::Vector3d(corner_ + (column + 0.5) * right_ +
                                      (row + 0.5) * down_)
                    : T_camera_map_ * canvas_.surface.middleOf(column, row);
  }

  /** Planes that look away are left out before. */
  bool
  faces(std::int32_t column, std::int32_t row) const
  {
    return isFlat() || canvas_.surface.faces(view_.T_map_camera.translation(),
                                             canvas_.surface.middleOf(column, row));
  }

  /** The columns of a row that may be in the box, from the first to the end. The row of a
   * plane is a straight line, of which each border of the box cuts a part off. */
  std::pair<std::int32_t, std::int32_t>
  columnsInView(std::int32_t row) const
  {
    const std::int32_t width = canvas_.chart.colors.width;
    if (!isFlat())
      return {0, width};
    const Eigen::Vector3d start = pointAt(0, row);
    const Eigen::Vector3d stop = pointAt(width, row);
    const auto distances = [&](const Eigen::Vector3d& point) {
      const double x = camera_.fx * point.x() + camera_.cx * point.z();
      const double y = camera_.fy * point.y() + camera_.cy * point.z();
      return std::array<double, 5>{point.z() - min_depth / 2,
                                   x - box_.min().x() * point.z(),
                                   y - box_.min().y() * point.z(),
                                   box_.max().x() * point.z() - x,
                                   box_.max().y() * point.z() - y};
    };
    const std::array<double, 5> from = distances(start), to = distances(stop);
    double first = 0, end = 1;
    for (std::size_t k = 0; k < from.size(); ++k) {
      if (from[k] < 0 && to[k] < 0)
        return {0, 0};
      const double crossing = from[k] / (from[k] - to[k]);
      if (from[k] < 0)
        first = std::max(first, crossing);
      else if (to[k] < 0)
        end = std::min(end, crossing);
    }
    return {static_cast<std::int32_t>(std::floor(first * width)),
            std::min(width, static_cast<std::int32_t>(std::ceil(end * width)) + 1)};
  }

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

  /** Area of the texel in the image, up to a constant factor; reduced towards the image
   * border. */
  double
  quality(std::int32_t column,
          std::int32_t row,
          const Eigen::Vector3d& point,
          const Eigen::Vector2d& pixel) const
  {
    constexpr double fade = 0.1; // fraction of the image width
    const double from_rim = std::min(
        {pixel.x(), pixel.y(), view_.width - 1 - pixel.x(), height_ - 1 - pixel.y()});
    const double rim = std::clamp(from_rim / (fade * view_.width), 0.01, 1.0);
    const double slant = distanceAlongNormal(column, row) / point.norm();
    return slant * rim / (point.z() * point.z());
  }

  /** Of the camera from the tangent plane at a texel. */
  double
  distanceAlongNormal(std::int32_t column, std::int32_t row) const
  {
    if (isFlat())
      return distance_;
    const Eigen::Vector3d middle = canvas_.surface.middleOf(column, row);
    return std::abs(canvas_.surface.normalAt(middle).dot(
        middle - view_.T_map_camera.translation()));
  }

  /** Mean over the pixels of the texel, as a texel may cover several of them; ignores
   * pixels that see something else. */
  Rgb
  meanColor(std::int32_t column,
            std::int32_t row,
            const Eigen::Vector3d& point,
            const Eigen::Vector2d& middle) const
  {
    const double pixels = texel_width_ * camera_.fx / point.z();
    const int side = static_cast<int>(std::clamp(std::round(pixels), 1.0, 5.0));
    Sums sums{};
    int count = 0;
    for (int v = 0; v < side; ++v)
      for (int u = 0; u < side; ++u) {
        const Eigen::Vector3d place =
            pointAt(column + (u + 0.5) / side - 0.5, row + (v + 0.5) / side - 0.5);
        if (!(place.z() > min_depth))
          continue;
        const Eigen::Vector2d pixel = camera_.project(place);
        if (!isInside(pixel))
          continue;
        const Corners corners = cornersOf(pixel);
        if (seesOthers(corners))
          continue;
        const Sums color = interpolated(pixel, corners);
        for (std::size_t k = 0; k < 3; ++k)
          sums[k] += color[k];
        ++count;
      }
    if (count == 0) {
      sums = interpolated(middle, cornersOf(middle));
      count = 1;
    }
    Rgb color;
    for (std::size_t k = 0; k < 3; ++k)
      color[k] = static_cast<std::uint8_t>(std::lround(sums[k] / count));
    return color;
  }

  using Sums = std::array<double, 3>;         // of red, green, blue
  using Corners = std::array<std::size_t, 4>; // row by row

  /** The four pixels around a position in the image. */
  Corners
  cornersOf(const Eigen::Vector2d& pixel) const
  {
    const int column = static_cast<int>(pixel.x());
    const int row = static_cast<int>(pixel.y());
    const std::size_t first = pixelAt(column, row);
    const std::size_t right = column < view_.width - 1 ? 1 : 0;
    const std::size_t below = pixelAt(column, row + 1);
    return {first, first + right, below, below + right};
  }

  /** Does one of them see something else than this surface? */
  bool
  seesOthers(const Corners& corners) const
  {
    return std::any_of(corners.begin(), corners.end(), [&](std::size_t pixel) {
      return seen_[pixel] != nothing &&
             seen_[pixel] != static_cast<std::int32_t>(canvas_.number);
    });
  }

  Sums
  interpolated(const Eigen::Vector2d& pixel, const Corners& corners) const
  {
    const double x = pixel.x() - static_cast<int>(pixel.x());
    const double y = pixel.y() - static_cast<int>(pixel.y());
    const double shares[] = {(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y};
    Sums sums{};
    for (std::size_t corner = 0; corner < corners.size(); ++corner) {
      const Rgb color = colorOf(view_, corners[corner]);
      for (std::size_t k = 0; k < 3; ++k)
        sums[k] += shares[corner] * color[k];
    }
    return sums;
  }

  const ColoredView& view_;
  const Pinhole& camera_;
  std::int32_t number_;
  const std::vector<std::int32_t>& seen_;
  const std::vector<VisibleSurface>& visible_;
  const PixelBox& box_;
  Canvas& canvas_;
  int height_; ///< pixels
  Eigen::Isometry3d T_camera_map_;
  double texel_width_; ///< metres
  // of a plane, in the frame of the camera
  Eigen::Vector3d corner_ = Eigen::Vector3d::Zero();                ///< of the chart
  Eigen::Vector3d right_ = Eigen::Vector3d::Zero(), down_ = right_; ///< a texel
  double distance_ = 0;                                             ///< of the plane
};

} // namespace

void
paintPinhole(const ColoredView& view,
             const Pinhole& camera,
             std::int32_t number,
             const PointLabels& nearest,
             std::vector<Canvas>& canvases)
{
  // surfaces, not canvases, as a texel at the border of a tile has neighbours on another
  // tile
  std::vector<std::int32_t> seen(nearest.size());
  parallelForChunks(nearest.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (nearest[i] >= 0)
        seen[i] = static_cast<std::int32_t>(
            canvases[static_cast<std::size_t>(nearest[i])].number);
      else
        seen[i] = view.points[i].allFinite() ? something_else : nothing;
  });
  const std::vector<VisibleSurface> visible = visibleSurfaces(seen, view.width);
  const std::vector<PixelBox> boxes =
      boxesOf(seen, view.width, canvases.empty() ? 0 : canvases.back().number + 1);
  oneapi::tbb::parallel_for(std::size_t{0}, canvases.size(), [&](std::size_t c) {
    Canvas& canvas = canvases[c];
    const PixelBox& box = boxes[canvas.number];
    if (box.isEmpty() || !canvas.surface.faces(view.T_map_camera.translation()))
      return;
    Painter painter(view, camera, number, seen, visible, box, canvas);
    oneapi::tbb::parallel_for(std::int32_t{0},
                              canvas.chart.colors.height,
                              [&](std::int32_t row) { painter.paintRow(row); });
  });
}

} // namespace pcl::acmap::texturing
