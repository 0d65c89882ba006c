#include "rgbd_observation.h"

#include <pcl/core/cloud_fields.h>

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

/** \brief All pixels with their colours, without points. */
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

/** Standard deviation along the ray. */
float
sigmaOf(const Eigen::Vector3d& point)
{
  return static_cast<float>(kinectDepthSigma(point.z()) * point.norm() / point.z());
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

std::vector<Eigen::Vector3f>
measuredPoints(const GrayImage16& depth,
               const Pinhole& camera,
               const DepthMeaning& meaning)
{
  const Eigen::Vector3f nothing =
      Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  std::vector<Eigen::Vector3f> points(depth.values.size(), nothing);
  std::size_t index = 0;
  for (std::int32_t row = 0; row < depth.height; ++row)
    for (std::int32_t column = 0; column < depth.width; ++column, ++index) {
      const double z = meaning.metres(depth.values[index]);
      if (z > 0.0)
        points[index] = (z * Eigen::Vector3d((column - camera.cx) / camera.fx,
                                             (row - camera.cy) / camera.fy,
                                             1.0))
                            .cast<float>();
    }
  return points;
}

PCLPointCloud2
observationCloud(const RgbImage& color, const std::vector<Eigen::Vector3f>& points)
{
  std::vector<Pixel> pixels = pixelsWithoutPoint(color);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (points[i].z() > 0)
      setPoint(pixels[i], points[i], sigmaOf(points[i].cast<double>()));
  return cloudOf(pixels, color.width, color.height);
}

PCLPointCloud2
registeredCloud(const RgbImage& color,
                const std::vector<Eigen::Vector3f>& points,
                const ColorCamera& color_camera)
{
  const Pinhole& seen = color_camera.pinhole;
  const Eigen::Isometry3d T_color_depth = color_camera.T_depth_color.inverse();
  std::vector<Pixel> pixels = pixelsWithoutPoint(color);
  for (const Eigen::Vector3f& measured : points) {
    const Eigen::Vector3d point = T_color_depth * measured.cast<double>();
    if (!(point.z() > 0.0)) // also true for NaN
      continue;
    const double column = std::round(seen.fx * point.x() / point.z() + seen.cx);
    const double row = std::round(seen.fy * point.y() / point.z() + seen.cy);
    if (!(column >= 0 && column < color.width && row >= 0 && row < color.height))
      continue;
    Pixel& pixel =
        pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(color.width) +
               static_cast<std::size_t>(column)];
    const Eigen::Vector3f place = point.cast<float>();
    if (!(pixel.z <= place.z())) // also true for NaN, if the pixel has no point yet
      setPoint(pixel, place, sigmaOf(measured.cast<double>()));
  }
  return cloudOf(pixels, color.width, color.height);
}

} // namespace pcl::acmap
