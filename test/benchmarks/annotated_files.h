#pragma once

#include <pcl/core/impl/moments.h>

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief A point with the number of its annotated plane, -1 for none. */
struct MarkedPoint {
  Eigen::Vector3f place; ///< metres; may be NaN
  std::int32_t plane = -1;
};

using MarkedPoints = std::vector<MarkedPoint>;

/** \brief Reads a PCD of the SynPEB scans, whose intensity is the number of the plane.
 * \param[in] path of a file, here and below */
MarkedPoints
readSynpeb(const std::string& path);

/** \brief Reads a PCD of the modified Object Segmentation Database: labels 1 to 9 are
 * the table; objects on it are not annotated here. */
MarkedPoints
readTable(const std::string& path);

/** \brief Reads a PCD whose labels are parts of a room, 0 for none. Parts count as
 * planes if they have at least 300 points and an RMS distance of less than 2 cm from
 * their plane. */
MarkedPoints
readRoomParts(const std::string& path);

/** \brief Reads a depth image of the ICL-NUIM camera, 5000 units per metre. The file
 * planes.txt beside it lists the pixels of one plane per line. */
MarkedPoints
readIclnuim(const std::string& path);

/** \brief Least-squares planes through the points of each number, up to the largest
 * number; fits of missing numbers are empty. */
std::vector<PlaneFit>
fitMarkedPlanes(const MarkedPoints& points);

/** \brief RMS distance of the points from their plane, metres. */
double
deviationOf(const PlaneFit& plane);

} // namespace pcl::acmap::bench
