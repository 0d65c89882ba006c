#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/planar_scan.h>
#include <pcl/pipeline/bag_settings.h>

#include <string>
#include <vector>

namespace pcl {

/** \brief The laser scans of a bag. \ingroup pipeline */
struct BagScans {
  std::vector<PlanarScan> scans;    ///< in the order of their times
  std::vector<std::string> remarks; ///< warnings, one per line
};

/** \brief Reads the laser scans (sensor_msgs/LaserScan) of a bag with their poses in the
 * plane: those of the frame of the laser by the transforms or the odometry of the bag,
 * relative to nothing. Of several topics the one with most messages is taken. Beams outside
 * of the range of the laser have no echo.
 * \throws InputFileException as \ref BagFile; if there are no scans, no poses, or the laser
 * does not measure in a horizontal plane
 * \throws BadArgumentException for settings as \ref openBag \ingroup pipeline */
ACMAP_EXPORT BagScans
loadBagScans(const std::string& path, const BagSettings& settings = {});

} // namespace pcl
