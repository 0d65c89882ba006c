#pragma once

#include <pcl/visualization/layered_scene.h>

namespace pcl::acmap {

/** \brief Whether points name the observations that saw them, in an int32 `view`. */
bool
hasViews(const PCLPointCloud2& cloud);

/** \brief The points as they lay under the poses before rectification: those of view i
 * moved by T_before_i * T_after_i^-1; those of no pose are left out.
 * \param[in] scene has a pose before for each pose, and points with views and x y z
 * \throws BadArgumentException when the fields are not inside the cloud */
PCLPointCloud2
pointsBefore(const LayeredScene& scene);

} // namespace pcl::acmap
