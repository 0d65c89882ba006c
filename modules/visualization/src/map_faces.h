#pragma once

#include <pcl/core/compact_map.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief What is drawn of one plane with one picture: convex faces, counter-clockwise seen
 * from the side that the plane's normal points to. */
struct MapFaces {
  std::size_t plane = 0;
  std::size_t polygon = 0;             ///< of the plane
  const TextureChart* chart = nullptr; ///< none: without a picture
  std::vector<Eigen::Vector3f> points; ///< metres
  std::vector<Eigen::Vector2f> places; ///< of the points on the picture, 0 to 1
  std::vector<std::vector<std::int32_t>> faces;
};

/** \brief Faces of all polygons, without pictures. */
std::vector<MapFaces>
facesOf(const CompactMap& map);

/** \brief The same, where polygons with charts are cut along the charts' borders; what no
 * chart covers is left out of these.
 * \throws BadArgumentException for charts that do not fit the map */
std::vector<MapFaces>
cutFaces(const CompactMap& map, const std::vector<MapFaces>& faces);

/** \brief Points spread evenly over faces, and their corners.
 * \throws InitFailedException when there is no face */
std::vector<Eigen::Vector3f>
samplesOf(const std::vector<MapFaces>& faces);

} // namespace pcl::acmap
