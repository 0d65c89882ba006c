#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/pipeline/rgbd_observation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace pcl {

namespace {

/** \brief Part of an image, pixels; its end is outside. */
struct ColorWindow {
  std::int32_t left, top, right, bottom;
};

std::array<std::uint8_t, 3>
meanOf(const RgbImage& image, const ColorWindow& window)
{
  std::array<std::uint64_t, 3> sums{};
  for (std::int32_t row = window.top; row < window.bottom; ++row)
    for (std::int32_t column = window.left; column < window.right; ++column)
      for (std::size_t i = 0; i < 3; ++i)
        sums[i] += image.at(column, row)[i];
  const auto pixels = static_cast<std::uint64_t>(window.right - window.left) *
                      static_cast<std::uint64_t>(window.bottom - window.top);
  std::array<std::uint8_t, 3> mean{};
  for (std::size_t i = 0; i < 3; ++i)
    mean[i] = static_cast<std::uint8_t>((sums[i] + pixels / 2) / pixels);
  return mean;
}

/** \brief The window of some pixels about a place; nothing of it may be in the image. */
ColorWindow
windowAbout(const Eigen::Vector2d& place, const Eigen::Vector2i& extent)
{
  const auto left =
      static_cast<std::int32_t>(std::lround(place.x() - 0.5 * (extent.x() - 1)));
  const auto top =
      static_cast<std::int32_t>(std::lround(place.y() - 0.5 * (extent.y() - 1)));
  return {left, top, left + extent.x(), top + extent.y()};
}

RgbImage
blackImage(const ImageSize& size)
{
  const auto pixels =
      static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  return {size.width, size.height, std::vector<std::uint8_t>(3 * pixels)};
}

void
requirePixels(const RgbImage& image, const ImageSize& size)
{
  const bool is_sound =
      image.width > 0 && image.height > 0 && size.width > 0 && size.height > 0 &&
      image.values.size() == 3 * static_cast<std::size_t>(image.width) *
                                 static_cast<std::size_t>(image.height);
  if (!is_sound)
    throw acmap::BadArgument("an image of ",
                             acmap::sizeText(image),
                             " pixels with ",
                             image.values.size(),
                             " values cannot be resampled to ",
                             acmap::sizeText(size),
                             " pixels");
}

} // namespace

RgbImage
resampledColors(const RgbImage& color,
                const std::vector<Eigen::Vector3f>& points,
                const ImageSize& depth_size,
                const Pinhole& depth_camera,
                const ColorCamera& color_camera)
{
  requirePixels(color, depth_size);
  RgbImage colors = blackImage(depth_size);
  if (points.size() * 3 != colors.values.size())
    throw acmap::BadArgument(points.size(),
                             " points are not one per pixel of ",
                             acmap::sizeText(depth_size));
  constexpr double far_away = 1e6; // metres, for pixels without a point
  const Pinhole& seen = color_camera.pinhole;
  const Eigen::Isometry3d T_color_depth = color_camera.T_depth_color.inverse();
  const auto pixelsPerPixel = [](double fine, double coarse) {
    return std::clamp(static_cast<int>(std::lround(fine / coarse)), 1, 64);
  };
  const Eigen::Vector2i extent(pixelsPerPixel(seen.fx, depth_camera.fx),
                               pixelsPerPixel(seen.fy, depth_camera.fy));
  std::size_t index = 0;
  for (std::int32_t row = 0; row < depth_size.height; ++row)
    for (std::int32_t column = 0; column < depth_size.width; ++column, ++index) {
      Eigen::Vector3d point = points[index].cast<double>();
      if (!(point.z() > 0)) // also true for NaN
        point = far_away * Eigen::Vector3d((column - depth_camera.cx) / depth_camera.fx,
                                           (row - depth_camera.cy) / depth_camera.fy,
                                           1);
      point = T_color_depth * point;
      if (!(point.z() > 0))
        continue;
      const Eigen::Vector2d place = seen.project(point);
      if (!(place.x() > -1 && place.x() < color.width && place.y() > -1 &&
            place.y() < color.height))
        continue;
      ColorWindow window = windowAbout(place, extent);
      window.left = std::max(window.left, 0);
      window.top = std::max(window.top, 0);
      window.right = std::min(window.right, color.width);
      window.bottom = std::min(window.bottom, color.height);
      if (window.left >= window.right || window.top >= window.bottom)
        continue;
      const auto mean = meanOf(color, window);
      std::copy(mean.begin(), mean.end(), colors.at(column, row));
    }
  return colors;
}

RgbImage
scaledImage(const RgbImage& image, const ImageSize& size)
{
  requirePixels(image, size);
  RgbImage scaled = blackImage(size);
  const auto range = [](std::int32_t at, std::int32_t from, std::int32_t to) {
    const auto begin = static_cast<std::int32_t>(std::int64_t{at} * from / to);
    const auto end = static_cast<std::int32_t>((std::int64_t{at} + 1) * from / to);
    return std::pair(begin, std::max(end, begin + 1));
  };
  for (std::int32_t row = 0; row < size.height; ++row)
    for (std::int32_t column = 0; column < size.width; ++column) {
      const auto [left, right] = range(column, image.width, size.width);
      const auto [top, bottom] = range(row, image.height, size.height);
      const auto mean = meanOf(image, {left, top, right, bottom});
      std::copy(mean.begin(), mean.end(), scaled.at(column, row));
    }
  return scaled;
}

} // namespace pcl
