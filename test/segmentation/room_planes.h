#pragma once

#include "clustering_runs.h"
#include "simulated_rooms.h"

namespace pcl::acmap::test {

/** \brief Result of all steps: consolidation, mesh, votes, planes. */
struct RoomPlanes : Clustered {
  std::vector<std::int32_t> truth; ///< true plane of most points of each patch
  double voxel = 0;                ///< metres
};

/** \param[in] set changes default settings */
RoomPlanes
findPlanes(
    const SeenRoom& room,
    const std::function<void(PlaneHypothesisClustering<PointXYZRGBNormalView>&)>& set =
        [](auto&) {});

/** \brief The patch of a true plane; nullptr if it was not found. */
const PlanePatch*
patchOf(const RoomPlanes& found, std::int32_t plane);

} // namespace pcl::acmap::test
