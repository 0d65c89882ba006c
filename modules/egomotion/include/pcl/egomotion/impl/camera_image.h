#pragma once

#include <pcl/common/point_tests.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/egomotion/impl/keypoint_kernel.h>
#include <pcl/point_cloud.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Checks that a cloud is an image, or empty.
 * \throws InitFailedException without a cloud, if it has not as many points as its header
 * claims, or for an index outside of it
 * \throws UnorganizedPointCloudException unless the cloud is organized */
template <typename PointT>
void
requireImage(const typename PointCloud<PointT>::ConstPtr& cloud, const Indices* indices)
{
  requireInput<PointT>(cloud, indices);
  if (!cloud->empty() && !cloud->isOrganized())
    refuseUnorganized();
}

/** \brief One value per pixel, not 0 if the pixel is among the indices and finite. */
template <typename PointT>
std::vector<std::uint8_t>
placesIn(const PointCloud<PointT>& cloud, const Indices& indices)
{
  std::vector<std::uint8_t> has_place(cloud.size());
  for (const index_t index : indices)
    has_place[static_cast<std::size_t>(index)] = isXYZFinite(cloud[index]);
  return has_place;
}

/** \brief The brightness of an organized cloud's colours: .299 r + .587 g + .114 b. */
template <typename PointT>
GreyImage
brightnessOf(const PointCloud<PointT>& cloud)
{
  GreyImage image;
  image.width = static_cast<int>(cloud.width);
  image.height = static_cast<int>(cloud.height);
  image.values.reserve(cloud.size());
  for (const PointT& point : cloud)
    image.values.push_back(0.299F * static_cast<float>(point.r) +
                           0.587F * static_cast<float>(point.g) +
                           0.114F * static_cast<float>(point.b));
  return image;
}

} // namespace pcl::acmap
