#include "rgbd_observation.h"

#include "cloud_fields.h"

#include <Eigen/Core>

#include <limits>

namespace pcl::acmap {

namespace {

struct Pixel {
  float x, y, z;
  std::uint32_t rgb;
  float sigma;
};

Pixel
pixelAt(double z, const Eigen::Vector3d& ray, const std::uint8_t* color)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  Pixel pixel{nan, nan, nan, 0, nan};
  pixel.rgb = std::uint32_t{color[0]} << 16 | std::uint32_t{color[1]} << 8 | color[2];
  if (z <= 0.0)
    return pixel;
  const Eigen::Vector3f point = (z * ray).cast<float>();
  pixel.x = point.x();
  pixel.y = point.y();
  pixel.z = point.z();
  pixel.sigma = static_cast<float>(kinectDepthSigma(z) * ray.norm());
  return pixel;
}

PCLPointCloud2
emptyCloud(std::int32_t width, std::int32_t height)
{
  constexpr auto real = PCLPointField::FLOAT32;
  PCLPointCloud2 cloud = layoutWith(
      {}, {{"x", real}, {"y", real}, {"z", real}, {"rgb", real}, {"sigma", real}});
  cloud.width = static_cast<uindex_t>(width);
  cloud.height = static_cast<uindex_t>(height);
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.data.resize(rowsOf(cloud) * cloud.point_step);
  return cloud;
}

} // namespace

PCLPointCloud2
observationCloud(const RgbImage& color,
                 const GrayImage16& depth,
                 const Pinhole& camera,
                 const DepthMeaning& meaning)
{
  PCLPointCloud2 cloud = emptyCloud(depth.width, depth.height);
  bool is_dense = true;
  std::size_t index = 0;
  for (std::int32_t row = 0; row < depth.height; ++row)
    for (std::int32_t column = 0; column < depth.width; ++column, ++index) {
      const Eigen::Vector3d ray(
          (column - camera.cx) / camera.fx, (row - camera.cy) / camera.fy, 1.0);
      const double z = meaning.metres(depth.values[index]);
      is_dense = is_dense && z > 0.0;
      setValue(cloud, index, 0, pixelAt(z, ray, color.at(column, row)));
    }
  cloud.is_dense = is_dense ? 1 : 0;
  return cloud;
}

} // namespace pcl::acmap
