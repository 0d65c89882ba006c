#pragma once

#include <pcl/core/moments.h>

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief A point with the number of the plane somebody marked, -1 for none. */
struct MarkedPoint {
  Eigen::Vector3f place; ///< metres; may be not finite
  std::int32_t plane = -1;
};

using MarkedPoints = std::vector<MarkedPoint>;

/** \brief A PCD of the SynPEB scans: its intensity is the number of the plane.
 * \param[in] path of a file, here and below */
MarkedPoints
readSynpeb(const std::string& path);

/** \brief A PCD of the modified Object Segmentation Database: its labels 1 to 9 are the
 * table; the objects on it are not marked here. */
MarkedPoints
readTable(const std::string& path);

/** \brief A PCD whose labels are parts of a room, 0 for none; parts that are planes are
 * marked: those of 300 points and more that lie within 2 cm of one, root mean square. */
MarkedPoints
readRoomParts(const std::string& path);

/** \brief An image of depths, 5000 a metre, of the ICL-NUIM camera, beside which a file
 * planes.txt lists the pixels of each plane in a line. */
MarkedPoints
readIclnuim(const std::string& path);

/** \brief The plane of least squares through the points of each number up to the largest;
 * without points for numbers that are not there. */
std::vector<PlaneFit>
fitMarkedPlanes(const MarkedPoints& points);

/** \brief Root mean square of the points off their plane, metres. */
double
deviationOf(const PlaneFit& plane);

} // namespace pcl::acmap::bench
