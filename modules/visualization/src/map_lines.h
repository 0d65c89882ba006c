#pragma once

#include <pcl/core/compact_map.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief A polyline, metres. */
struct MapLine {
  std::size_t plane = 0;
  std::vector<Eigen::Vector3f> points;
};

void
append(std::vector<MapLine>& lines, std::vector<MapLine> more);

/** \brief Outlines and holes of a plane's polygons as closed polylines, without points
 * that are not finite. */
std::vector<MapLine>
outlinesOf(const CompactMap& map, std::size_t plane);

/** \brief Intersection of a plane's polygons with a horizontal plane, as segments.
 * \param[in] up unit vector
 * \param[in] level height along up, metres */
std::vector<MapLine>
sectionOf(const CompactMap& map,
          std::size_t plane,
          const Eigen::Vector3d& up,
          double level);

} // namespace pcl::acmap
