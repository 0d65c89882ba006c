#pragma once

#include "clustering_runs.h"
#include "simulated_rooms.h"

namespace pcl::acmap::test {

/** \brief What came out of the whole way: consolidation, mesh, votes, planes. */
struct RoomPlanes : Clustered {
  std::vector<std::int32_t> truth; ///< of each patch, where most of its points are of
  double voxel = 0;                ///< metres
};

/** \param[in] set what is not to stay at its default */
RoomPlanes
findPlanes(
    const SeenRoom& room,
    const std::function<void(PlaneHypothesisClustering<PointXYZRGBNormalView>&)>& set =
        [](auto&) {});

/** \brief The patch of a true plane; nullptr where none was found. */
const PlanePatch*
patchOf(const RoomPlanes& found, std::int32_t plane);

} // namespace pcl::acmap::test
