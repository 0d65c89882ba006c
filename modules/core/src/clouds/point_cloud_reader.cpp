#include "clouds/text_layout.h"

#include <pcl/core/impl/arguments.h>
#include <pcl/core/point_cloud_reader.h>

namespace pcl {

namespace {

void
requireNear(const std::string& name, const Eigen::Vector3d& place)
{
  for (const double coordinate : place)
    acmap::requireInRange(name, coordinate, -1e9, 1e9, "m");
}

} // namespace

void
PointCloudReader::setScale(double scale)
{
  acmap::requireInRange("scale", scale, 1e-12, 1e12, "m");
  scale_ = stated_.scale = scale;
  stated_.is_scale_stated = true;
}

void
PointCloudReader::setShift(const Eigen::Vector3d& shift)
{
  requireNear("shift", shift);
  stated_.shift = shift;
}

void
PointCloudReader::setColumns(const std::vector<std::string>& columns)
{
  acmap::rolesOfColumns(columns);
  stated_.columns = columns;
}

void
PointCloudReader::setUpDirection(const Eigen::Vector3d& up)
{
  up_ = acmap::requiredDirection(up);
}

void
PointCloudReader::setSensorOrigin(const Eigen::Vector3d& origin)
{
  requireNear("sensor origin", origin);
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
  PointCloudFile file = acmap::loadStatedCloud(path, stated_);
  state(file);
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
  CloudRows rows = acmap::loadCloudRows(path, stated_, file);
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
    file.sensor_origin = (origin_ - file.shift).cast<float>();
}

} // namespace pcl
