#pragma once

#include "plane_finders.h"
#include "simulated_clouds.h"

namespace pcl::acmap::bench {

using NamedFinders = std::vector<NamedFinder>;

/** \brief One view of the corridor. */
void
printViewPlanes(const SceneData& corridor, const NamedFinders& finders);

/** \brief Sums over views along the whole corridor. */
void
printAllViewsPlanes(const SceneData& corridor, const NamedFinders& finders);

/** \brief The same view with disparity noise of half a pixel. */
void
printNoisyViewPlanes(const SceneData& corridor, const NamedFinders& finders);

/** \brief A million random points of the corridor. */
void
printMillionPlanes(SceneData& corridor, const NamedFinders& finders);

/** \brief All points of the corridor. */
void
printWholePlanes(SceneData& corridor, const NamedFinders& finders);

/** \brief Maps with drifting poses: how often is a plane split into several? */
void
printDriftPlanes(const NamedFinder& finder);

/** \brief Boards and a curved wall, for which the number of planes is known. */
void
printShapePlanes(const NamedFinders& finders);

/** \brief Annotated real clouds. */
void
printRealPlanes(const NamedFinders& finders);

} // namespace pcl::acmap::bench
