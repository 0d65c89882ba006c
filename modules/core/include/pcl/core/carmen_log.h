#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/planar_scan.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief The laser scans of a CARMEN log. \ingroup core */
struct CarmenLog {
  std::vector<PlanarScan> scans; ///< of its front laser, in the order of the log
  /** \brief Number of ignored messages, without comments and blank lines. */
  std::size_t other_messages = 0;
  /** \brief Angle from the first to the last direction of FLASER messages, radians; 0 for
   * ROBOTLASER1 messages, which have their angles. */
  double sweep = 0;
  bool is_sweep_stated = false;     ///< by the log or the caller; otherwise assumed
  std::vector<std::string> remarks; ///< warnings, one per line
};

/** \brief Reads a CARMEN log, uncompressed or compressed by gzip. It consists of lines
 * `FLASER n r_1 .. r_n x y theta odom_x odom_y odom_theta stamp host stamp`, or of lines
 * `ROBOTLASER1 type first_angle sweep step maximum_range accuracy remission_mode n r_1 .. r_n
 * m s_1 .. s_m x y theta` and what follows. Other messages are counted and ignored, and
 * ROBOTLASER1 beside FLASER, too.
 *
 * The pose of a scan is the first one of its line (x forward, y left, theta
 * counter-clockwise, radians), converted to a PlanarPose: z = x, x = -y,
 * theta = -theta. Its stamp is that of the message. Beams of FLASER sweep from right to left,
 * 180 degrees if neither `PARAM laser_front_laser_fov` nor the caller states another angle:
 * an odd number of beams includes both ends, an even number excludes the last direction.
 * Ranges are not changed, even if they are NaN. maximum_range is at most that of the message,
 * and excludes the value that the laser of the log reports for a missing echo.
 * \param[in] sweep of FLASER messages, radians, in place of what the log states
 * \throws InputFileException naming file, line and fault: fewer numbers than announced,
 * a word that is not a number, fewer than two beams, a pose, angle or stamp that is not
 * finite, a number of beams of lasers that have another sweep than 180 degrees if none is
 * stated; a file that is missing, empty, or has damaged compression; no scan
 * \throws BadArgumentException for a sweep outside of (0, 2 pi] \ingroup core */
ACMAP_EXPORT CarmenLog
loadCarmenLog(const std::string& path, std::optional<double> sweep = {});

/** \brief Writes scans as a CARMEN log that \ref loadCarmenLog reads with the same
 * ranges, angles, poses and stamps: as FLASER messages, or as ROBOTLASER1 if their beams do not
 * sweep 180 degrees from right to left.
 * \param[in] odometry poses of the odometry, one per scan, which the log has beside those of
 * the scans; empty: these again
 * \throws BadArgumentException for a scan with fewer than two beams or without angles, or
 * another number of poses
 * \throws OutputFileException when it could not be written completely \ingroup core */
ACMAP_EXPORT void
saveCarmenLog(const std::string& path,
              const std::vector<PlanarScan>& scans,
              const std::vector<PlanarPose>& odometry = {});

} // namespace pcl
