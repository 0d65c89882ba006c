#pragma once

#include "plane_finders.h"
#include "simulated_clouds.h"

namespace pcl::acmap::bench {

using NamedFinders = std::vector<NamedFinder>;

/** \brief One view of the corridor. */
void
printViewPlanes(const SceneData& corridor, const NamedFinders& finders);

/** \brief Views all along the corridor, summed up. */
void
printAllViewsPlanes(const SceneData& corridor, const NamedFinders& finders);

/** \brief The same view as a camera sees it whose disparities are off by half a pixel. */
void
printNoisyViewPlanes(const SceneData& corridor, const NamedFinders& finders);

/** \brief A million random points of the corridor. */
void
printMillionPlanes(SceneData& corridor, const NamedFinders& finders);

/** \brief All points of the corridor. */
void
printWholePlanes(SceneData& corridor, const NamedFinders& finders);

/** \brief Maps whose poses drift: how often one plane comes as several. */
void
printDriftPlanes(const NamedFinder& finder);

/** \brief Boards and a curved wall: how many planes are found where it is plain how many
 * there are. */
void
printShapePlanes(const NamedFinders& finders);

/** \brief Annotated real clouds. */
void
printRealPlanes(const NamedFinders& finders);

} // namespace pcl::acmap::bench
