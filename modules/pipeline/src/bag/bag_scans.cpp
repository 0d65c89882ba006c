#include "bag/sensor_mounting.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/pipeline/bag_scans.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace pcl {

namespace acmap {

namespace {

/** \brief Converts scans to those of a plane. */
class BagScanReading {
public:
  BagScanReading(const std::string& path, const BagSettings& settings)
  : topics_(path)
  , settings_(settings)
  {}

  BagScans
  read()
  {
    const BagTopic* const largest = topics_.largestOf(scan_type);
    if (!largest)
      topics_.fail("has no laser scans (" + std::string(scan_type) + ")" + otherTool() +
                   "; its topics: " + topics_.list());
    topic_ = *largest;
    if (topics_.ofType(scan_type).size() > 1)
      topics_.remark("took the scans of " + topic_.name);
    const std::vector<double> stamps = topics_.sortByStamps(topic_);
    frame_ = topics_.read(topic_, topic_.messages.front(), readRosHeader).frame;
    if (!connectSensor(topics_, frame_, false, settings_))
      topics_.fail("has no poses for the scans of " + topic_.name +
                   ": neither odometry nor transforms that move " + frame_ +
                   "; its topics: " + topics_.list());
    BagScans scans;
    std::size_t unposed = 0;
    for (std::size_t i = 0; i < stamps.size(); i += settings_.every)
      if (std::optional<PlanarScan> scan = scanAt(i, stamps[i]))
        scans.scans.push_back(std::move(*scan));
      else
        ++unposed;
    if (scans.scans.empty())
      topics_.fail("has no pose of " + frame_ + " at the times of its scans");
    if (unposed > 0)
      topics_.remark(std::to_string(unposed) +
                     " scans left out: no pose is known near them");
    excludeMissingEchoes(scans.scans);
    scans.remarks = topics_.remarks();
    return scans;
  }

private:
  /** \brief The tool for a bag of images or clouds. */
  std::string
  otherTool() const
  {
    for (const char* type : {"sensor_msgs/Image",
                             "sensor_msgs/CompressedImage",
                             "sensor_msgs/PointCloud2"})
      if (topics_.largestOf(type))
        return ": run pcl_compact_mapping " + topics_.bag().path() +
               " -o map for its images or clouds";
    return {};
  }

  std::optional<PlanarScan>
  scanAt(std::size_t i, double stamp) const
  {
    const RosScan read = topics_.read(topic_, topic_.messages[i], readRosScan);
    const auto T_root_laser = topics_.tree().poseInRoot(frame_, stamp);
    if (!T_root_laser)
      return {};
    const double side = sideOf(*T_root_laser);
    const Eigen::Vector3d ahead = T_root_laser->linear().col(0),
                          place = T_root_laser->translation();
    PlanarScan scan;
    scan.stamp = stamp;
    // x ahead and y left become z and -x, and angles those from z to x
    scan.pose = {0.0 - place.y(), place.x(), 0.0 - std::atan2(ahead.y(), ahead.x())};
    scan.first_angle = -side * read.first_angle;
    scan.angle_step = -side * read.angle_step;
    scan.maximum_range = std::numeric_limits<float>::infinity();
    if (read.max_range > 0)
      scan.maximum_range = static_cast<float>(read.max_range);
    for (const float range : read.ranges)
      scan.ranges.push_back(range >= read.min_range ? range : 0.0F);
    return scan;
  }

  /** \brief 1 for a laser whose z axis points up, -1 for one that is mounted upside down. */
  double
  sideOf(const Eigen::Isometry3d& T_root_laser) const
  {
    const double up = T_root_laser.linear()(2, 2);
    constexpr double max_tilt = 0.35; // radians
    if (std::abs(up) < std::cos(max_tilt))
      topics_.fail("has scans of " + frame_ +
                   " that are not in a horizontal plane, but tilted by more than 20 "
                   "degrees");
    return up > 0 ? 1 : -1;
  }

  BagTopics topics_;
  const BagSettings& settings_;
  BagTopic topic_;
  std::string frame_;
};

} // namespace

} // namespace acmap

BagScans
loadBagScans(const std::string& path, const BagSettings& settings)
{
  if (settings.every == 0)
    acmap::refuseArgument("every", settings.every, "at least 1");
  if (settings.ignores_poses)
    throw acmap::BadArgument("laser scans need the poses of their bag");
  return acmap::BagScanReading(path, settings).read();
}

} // namespace pcl
