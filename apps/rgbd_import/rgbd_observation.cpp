#include "rgbd_observation.h"

#include "cloud_fields.h"

#include <Eigen/Core>

#include <cmath>
#include <limits>

namespace pcl::acmap {

namespace {

/** A row of the cloud. */
struct Pixel {
  float x, y, z;
  std::uint32_t rgb;
  float sigma;
};

/** \brief What every pixel has: its colour. */
std::vector<Pixel>
pixelsWithoutPoint(const RgbImage& color)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<Pixel> pixels;
  pixels.reserve(color.values.size() / 3);
  for (std::size_t i = 0; i + 2 < color.values.size(); i += 3)
    pixels.push_back({nan,
                      nan,
                      nan,
                      std::uint32_t{color.values[i]} << 16 |
                          std::uint32_t{color.values[i + 1]} << 8 | color.values[i + 2],
                      nan});
  return pixels;
}

void
setPoint(Pixel& pixel, const Eigen::Vector3f& point, float sigma)
{
  pixel.x = point.x();
  pixel.y = point.y();
  pixel.z = point.z();
  pixel.sigma = sigma;
}

/** \brief Calls use (pixel's index, point, sigma) for all that was measured. */
template <typename Use>
void
forEachPoint(const GrayImage16& depth,
             const Pinhole& camera,
             const DepthMeaning& meaning,
             const Use& use)
{
  std::size_t index = 0;
  for (std::int32_t row = 0; row < depth.height; ++row)
    for (std::int32_t column = 0; column < depth.width; ++column, ++index) {
      const double z = meaning.metres(depth.values[index]);
      if (z <= 0.0)
        continue;
      const Eigen::Vector3d ray(
          (column - camera.cx) / camera.fx, (row - camera.cy) / camera.fy, 1.0);
      const Eigen::Vector3d point = z * ray;
      use(index, point, static_cast<float>(kinectDepthSigma(z) * ray.norm()));
    }
}

PCLPointCloud2
cloudOf(const std::vector<Pixel>& pixels, std::int32_t width, std::int32_t height)
{
  constexpr auto real = PCLPointField::FLOAT32;
  PCLPointCloud2 cloud = layoutWith(
      {}, {{"x", real}, {"y", real}, {"z", real}, {"rgb", real}, {"sigma", real}});
  cloud.width = static_cast<uindex_t>(width);
  cloud.height = static_cast<uindex_t>(height);
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.data.resize(rowsOf(cloud) * cloud.point_step);
  bool is_dense = true;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    is_dense = is_dense && pixels[i].z > 0.0F;
    setValue(cloud, i, 0, pixels[i]);
  }
  cloud.is_dense = is_dense ? 1 : 0;
  return cloud;
}

} // namespace

PCLPointCloud2
observationCloud(const RgbImage& color,
                 const GrayImage16& depth,
                 const Pinhole& camera,
                 const DepthMeaning& meaning)
{
  std::vector<Pixel> pixels = pixelsWithoutPoint(color);
  forEachPoint(depth,
               camera,
               meaning,
               [&](std::size_t index, const Eigen::Vector3d& point, float sigma) {
                 setPoint(pixels[index], point.cast<float>(), sigma);
               });
  return cloudOf(pixels, color.width, color.height);
}

PCLPointCloud2
registeredCloud(const RgbImage& color,
                const GrayImage16& depth,
                const Pinhole& camera,
                const DepthMeaning& meaning,
                const ColorCamera& color_camera)
{
  const Pinhole& seen = color_camera.pinhole;
  const Eigen::Isometry3d T_color_depth = color_camera.T_depth_color.inverse();
  std::vector<Pixel> pixels = pixelsWithoutPoint(color);
  const auto put = [&](std::size_t, const Eigen::Vector3d& measured, float sigma) {
    const Eigen::Vector3d point = T_color_depth * measured;
    if (!(point.z() > 0.0))
      return;
    const double column = std::round(seen.fx * point.x() / point.z() + seen.cx);
    const double row = std::round(seen.fy * point.y() / point.z() + seen.cy);
    if (!(column >= 0 && column < color.width && row >= 0 && row < color.height))
      return;
    Pixel& pixel =
        pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(color.width) +
               static_cast<std::size_t>(column)];
    const Eigen::Vector3f place = point.cast<float>();
    if (!(pixel.z <= place.z())) // NaN: the first one
      setPoint(pixel, place, sigma);
  };
  forEachPoint(depth, camera, meaning, put);
  return cloudOf(pixels, color.width, color.height);
}

} // namespace pcl::acmap
