#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/planar_scan.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {

/** \brief The laser messages of a CARMEN log. \ingroup core */
struct CarmenLog {
  std::vector<PlanarScan> scans;  ///< of FLASER messages, in the order of the log
  std::size_t other_messages = 0; ///< left out; comments and blank lines do not count
};

/** \brief Reads a CARMEN log, plain or compressed by gzip: lines
 * `FLASER n r_1 .. r_n x y theta odom_x odom_y odom_theta stamp host stamp`; other
 * messages are counted and left out.
 *
 * A scan's pose is the first one (x ahead, y left, theta to the left, radians), turned
 * into a PlanarPose: z = x, x = -y, theta = -theta. Its stamp is the first one. Beams
 * sweep 180 degrees from the right to the left: odd numbers of them include both ends,
 * even ones leave the last out. Ranges stay as they are, NaN too; maximum_range, one
 * for all scans, excludes the reading that the log's laser gives without an echo.
 * \throws InputFileException naming file, line and fault: fewer numbers than
 * announced, a word that is no number, fewer than two beams, a pose or stamp that is
 * not finite; a file that is missing, empty, or damaged in its compression; no scan
 * \ingroup core */
ACMAP_EXPORT CarmenLog
loadCarmenLog(const std::string& path);

} // namespace pcl
