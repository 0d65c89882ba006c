#pragma once

#include "plane_landmarks.h"

#include <vector>

namespace pcl::acmap {

/** \brief Measures the systematic error of surfaces: the part of the distances between
 * views and the planes that they share which the noise of the points does not explain.
 * By medians in bins of distance, so that wrong associations do not count.
 * \param[in] before kept where there are too few planes with three views */
SurfaceFloor
measureFloor(const std::vector<Landmark>& landmarks,
             const Poses& poses,
             const SurfaceFloor& before);

} // namespace pcl::acmap
