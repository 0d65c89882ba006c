#pragma once

#include <pcl/pipeline/next_positions.h>

#include <string>

namespace pcl::acmap {

/** \brief Says where a position is, and at what one looks from there.
 * \param[in] looked_at middle of what it uncovers, metres in the map frame
 * \param[in] role of most of it */
std::string
wordsOf(const NextPosition& position,
        const Eigen::Vector3d& looked_at,
        SurfaceRole role,
        const CompactMap& map,
        const FloorPlan& plan);

} // namespace pcl::acmap
