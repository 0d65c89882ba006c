#pragma once

#include <pcl/core/compact_map.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief A polyline, metres. */
struct MapLine {
  std::size_t plane = 0; ///< or the number of planes plus that of the cylinder
  std::vector<Eigen::Vector3f> points;
};

void
append(std::vector<MapLine>& lines, std::vector<MapLine> more);

/** \brief Outlines and holes of a plane's polygons as closed polylines, without points
 * that are not finite. */
std::vector<MapLine>
outlinesOf(const CompactMap& map, std::size_t plane);

/** \brief The rim of a cylinder of a map as a closed polyline; nothing if it has no
 * facets. */
std::vector<MapLine>
rimOf(const CompactMap& map, std::size_t cylinder);

/** \brief Intersection of a plane's polygons with a horizontal plane, as segments.
 * \param[in] number of the plane
 * \param[in] up unit vector
 * \param[in] level height along up, metres */
std::vector<MapLine>
sectionOf(const PlanePatch& plane,
          std::size_t number,
          const Eigen::Vector3d& up,
          double level);

} // namespace pcl::acmap
