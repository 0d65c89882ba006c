#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/planar_scan.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {

/** \brief The laser scans of a CARMEN log. \ingroup core */
struct CarmenLog {
  std::vector<PlanarScan> scans; ///< from FLASER messages, in the order of the log
  /** \brief Number of ignored messages, without comments and blank lines. */
  std::size_t other_messages = 0;
};

/** \brief Reads a CARMEN log, uncompressed or compressed by gzip. It consists of lines
 * `FLASER n r_1 .. r_n x y theta odom_x odom_y odom_theta stamp host stamp`. Other
 * messages are counted and ignored.
 *
 * The pose of a scan is the first one of its line (x forward, y left, theta
 * counter-clockwise, radians), converted to a PlanarPose: z = x, x = -y,
 * theta = -theta. Its stamp is the first one of the line. The beams sweep 180 degrees
 * from right to left: an odd number of beams includes both ends, an even number
 * excludes the last direction. Ranges are not changed, even if they are NaN.
 * maximum_range, which is the same for all scans, excludes the value that the laser of
 * the log reports for a missing echo.
 * \throws InputFileException naming file, line and fault: fewer numbers than announced,
 * a word that is not a number, fewer than two beams, a pose or stamp that is not
 * finite; a file that is missing, empty, or has damaged compression; no scan
 * \ingroup core */
ACMAP_EXPORT CarmenLog
loadCarmenLog(const std::string& path);

/** \brief Writes scans as a CARMEN log that \ref loadCarmenLog reads with the same
 * ranges, poses and stamps.
 * \param[in] odometry poses of the odometry, one per scan, which the log has beside those of
 * the scans; empty: these again
 * \throws BadArgumentException for a scan whose beams do not sweep 180 degrees as those
 * of a log do, or another number of poses
 * \throws OutputFileException when it could not be written completely \ingroup core */
ACMAP_EXPORT void
saveCarmenLog(const std::string& path,
              const std::vector<PlanarScan>& scans,
              const std::vector<PlanarPose>& odometry = {});

} // namespace pcl
