#include "egomotion_observation.h"

#include "cloud_fields.h"
#include "scaled_cloud.h"

namespace pcl::acmap {

namespace {

PointCloud<PointXYZRGBSigma>::ConstPtr
pointsWithColor(const PCLPointCloud2& from)
{
  const std::size_t place = findField(from, "x")->offset;
  const std::size_t color = findColor(from)->offset;
  const PCLPointField* const sigma = findField(from, "sigma", PCLPointField::FLOAT32);
  PointCloud<PointXYZRGBSigma>::Ptr cloud(
      new PointCloud<PointXYZRGBSigma>(from.width, from.height));
  cloud->is_dense = from.is_dense != 0;
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    PointXYZRGBSigma& point = (*cloud)[i];
    const std::uint8_t* const row = &from.data[i * from.point_step];
    std::memcpy(point.data, row + place, 3 * sizeof(float));
    std::memcpy(&point.rgba, row + color, sizeof point.rgba);
    if (sigma)
      std::memcpy(&point.sigma, row + sigma->offset, sizeof point.sigma);
  }
  return cloud;
}

} // namespace

EgomotionObservation
loadEgomotionObservation(const std::string& path, std::size_t index, double scale)
{
  EgomotionObservation observation;
  observation.index = index;
  observation.file = loadScaledCloud(path, scale);
  const PCLPointCloud2& cloud = observation.file.cloud;
  if (cloud.height < 2)
    throw InputFileException(path +
                             ": is not organized, it has one row of points only");
  if (!findColor(cloud))
    throw InputFileException(path + ": has no colour, a field rgb is needed");
  observation.cloud = pointsWithColor(cloud);
  return observation;
}

} // namespace pcl::acmap
