#pragma once

#include <pcl/visualization/layered_scene.h>

namespace pcl::acmap {

/** \brief Do the points have an int32 field `view`, the number of their observation? */
bool
hasViews(const PCLPointCloud2& cloud);

/** \brief The points under the poses before rectification: those of view i are moved by
 * T_before_i * T_after_i^-1; points without a valid view become NaN.
 * \param[in] scene has an earlier pose for each pose, and points with view and x y z
 * \throws BadArgumentException when the fields are missing or not inside the cloud */
PCLPointCloud2
pointsBefore(const LayeredScene& scene);

} // namespace pcl::acmap
