#pragma once

#include <pcl/core/compact_map.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief A line through points, metres. */
struct MapLine {
  std::size_t plane = 0;
  std::vector<Eigen::Vector3f> points;
};

void
append(std::vector<MapLine>& lines, std::vector<MapLine> more);

/** \brief Rims and holes of a plane's polygons as closed lines, without points that are not
 * finite. */
std::vector<MapLine>
outlinesOf(const CompactMap& map, std::size_t plane);

/** \brief Where a plane's polygons meet a level plane, as pieces of two points.
 * \param[in] up of length 1
 * \param[in] level along up, metres */
std::vector<MapLine>
sectionOf(const CompactMap& map,
          std::size_t plane,
          const Eigen::Vector3d& up,
          double level);

} // namespace pcl::acmap
