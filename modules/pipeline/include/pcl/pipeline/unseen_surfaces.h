#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/core/surface_label.h>
#include <pcl/texture/floor_plan.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl {

/** \brief A small part of floor, ceiling or walls of a room that no observation saw.
 * \ingroup pipeline */
struct UnseenPatch {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< metres, in the map frame
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< into the room, of length 1
  double area = 0;                                  ///< square metres
  SurfaceRole role = SurfaceRole::Other;            ///< Floor, Ceiling or Wall
  std::int32_t room = -1;                           ///< index in the plan

  /** \brief No wall was seen at all where the room ends here: it may go on. */
  bool is_open = false;
};

/** \brief What encloses the rooms of a map, and what of it no observation saw.
 * \ingroup pipeline */
struct UnseenSurfaces {
  std::vector<UnseenPatch> patches;
  double seen_area = 0, unseen_area = 0; ///< square metres
  double patch_size = 0;                 ///< metres

  /** \brief Share of floor, ceiling and walls that was seen; NaN without a room. */
  double
  seenShare() const
  {
    return seen_area / (seen_area + unseen_area);
  }
};

/** \brief Finds what no observation saw of floors, ceilings and walls within the outlines of the
 * rooms.
 *
 * Floors and ceilings are asked in squares of 20 cm, walls along the outlines of the rooms from floor
 * to ceiling. A square was seen if a polygon of the map has its middle: for a wall one of an upright
 * plane within 0.35 m, for a ceiling one that faces down. A room of which no ceiling was seen is as high
 * as the others, or 2.5 m. Openings are no walls; what furniture stands on, or directly in
 * front of, is not asked. There are at most 60 000 squares; those of larger maps are larger.
 * \param[in] plan from \ref makeFloorPlan for this map, whose planes have their roles
 * (\ref nameSurfaces) \ingroup pipeline */
ACMAP_EXPORT UnseenSurfaces
findUnseenSurfaces(const CompactMap& map, const FloorPlan& plan);

} // namespace pcl
