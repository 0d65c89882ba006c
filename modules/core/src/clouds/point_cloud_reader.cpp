#include <pcl/core/impl/arguments.h>
#include <pcl/core/point_cloud_reader.h>

namespace pcl {

void
PointCloudReader::setScale(double scale)
{
  acmap::requireInRange("scale", scale, 1e-12, 1e12, "m");
  scale_ = scale;
}

void
PointCloudReader::setUpDirection(const Eigen::Vector3d& up)
{
  up_ = acmap::requiredDirection(up);
}

void
PointCloudReader::setSensorOrigin(const Eigen::Vector3f& origin)
{
  acmap::requireViewpoints({origin});
  sensor_ = SensorStatement::Stated;
  origin_ = origin;
}

void
PointCloudReader::setWithoutSensor()
{
  sensor_ = SensorStatement::NoSensor;
}

PointCloudFile
PointCloudReader::read(const std::string& path) const
{
  PointCloudFile file = loadPointCloud(path);
  apply(file);
  return file;
}

void
PointCloudReader::apply(PointCloudFile& file) const
{
  acmap::scaleCloud(file, getScale());
  state(file);
}

CloudRows
PointCloudReader::readRows(const std::string& path, PointCloudFile& file) const
{
  CloudRows rows = acmap::loadCloudRows(path, getScale(), file);
  state(file);
  return rows;
}

void
PointCloudReader::state(PointCloudFile& file) const
{
  if (scale_)
    file.stated_scale = scale_;
  if (up_)
    file.up = up_->cast<float>();
  if (sensor_ == SensorStatement::Unstated)
    return;
  file.sensor_statement = sensor_;
  if (sensor_ == SensorStatement::Stated)
    file.sensor_origin = origin_;
}

} // namespace pcl
