#pragma once

#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/point_types.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/point_cloud.h>

#include <cstddef>
#include <cstring>
#include <memory>
#include <mutex>
#include <type_traits>

namespace pcl::acmap {

/** \brief Can keypoints be found in an observation? */
inline bool
isImage(const PCLPointCloud2& cloud)
{
  return cloud.height > 1 && findColor(cloud);
}

/** \brief Coordinates of a file, and sigma and colours if the point type has them. */
template <typename PointT>
typename PointCloud<PointT>::ConstPtr
measuredCloud(const PointCloudFile& file)
{
  const PointView points = file.points();
  auto cloud = std::make_shared<PointCloud<PointT>>();
  cloud->resize(points.size());
  if (std::size_t{file.cloud.width} * file.cloud.height == points.size()) {
    cloud->width = file.cloud.width;
    cloud->height = file.cloud.height;
  }
  const PCLPointField* const sigma =
      findField(file.cloud, "sigma", PCLPointField::FLOAT32);
  const PCLPointField* const color = findColor(file.cloud);
  for (std::size_t i = 0; i < points.size(); ++i) {
    PointT& point = (*cloud)[i];
    point.getVector3fMap() = points[i];
    if constexpr (std::is_same_v<PointT, PointXYZRGBSigma>) {
      const std::uint8_t* const row =
          file.cloud.data.data() + i * file.cloud.point_step;
      if (sigma)
        std::memcpy(&point.sigma, row + sigma->offset, sizeof point.sigma);
      if (color)
        std::memcpy(&point.rgba, row + color->offset, sizeof point.rgba);
    }
  }
  return cloud;
}

/** \brief Reads observations for several threads: the cache of a sequence is not for them. */
class LockedReader {
public:
  explicit LockedReader(const ObservationSequence& sequence)
  : sequence_(sequence)
  {}

  template <typename PointT>
  auto
  loader(std::size_t i)
  {
    return [this, i] {
      std::shared_ptr<const PointCloudFile> file;
      {
        const std::lock_guard<std::mutex> lock(reading_);
        file = sequence_.load(i).file;
      }
      return measuredCloud<PointT>(*file);
    };
  }

private:
  const ObservationSequence& sequence_;
  std::mutex reading_;
};

} // namespace pcl::acmap
