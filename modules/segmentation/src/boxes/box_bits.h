#pragma once

#include "boxes/box.h"
#include "boxes/piece.h"

#include <vector>

namespace pcl::acmap::boxes {

/** Scale of the description of a map. */
struct MapScale {
  double sigma = 0;  ///< metres; root mean square distance of the points from planes
  double extent = 0; ///< metres

  MapScale(const std::vector<PlanePatch>& planes, const std::vector<Piece>& pieces);
};

/** The effective number of points of a plane, at least 1. */
double
pointsOn(const PlanePatch& plane);

/** Sets the bits of the planes of a box, and those that it saves.
 * \param[in] templates number of sizes that are already described
 * \param[in] is_instance the size is one of these */
void
measureBits(const std::vector<PlanePatch>& planes,
            const std::vector<Piece>& pieces,
            const MapScale& scale,
            std::size_t templates,
            bool is_instance,
            Box& box);

} // namespace pcl::acmap::boxes
