#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/export.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/simulation/scene_geometry.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <limits>
#include <vector>

namespace pcl {

/** \brief What each pixel of a view looks at, row by row. Colour and noise come later:
 * a view is cast once and may be shaded often. \ingroup simulation */
struct SurfaceImage {
  int width = 0;                     ///< px
  int height = 0;                    ///< px
  std::vector<double> distance;      ///< metres along the unit ray, NaN for nothing
  std::vector<std::int32_t> surface; ///< index in the scene, -1 for nothing
};

/** \brief The direction a pixel looks along, of unit length, in the camera frame.
 * \ingroup simulation */
ACMAP_EXPORT Eigen::Vector3d
pixelRay(const TrinocularRig& rig, int column, int row);

/** \brief Casts a ray through each pixel, exactly: no triangles, no sampling.
 *
 * Of surfaces at the same distance the earlier one is hit. Surfaces outside the view are
 * sorted out first; each other one costs about its pixels. Runs in all threads of the
 * caller's arena (\ref acmap::withThreads), with the same result for any number.
 * \param[in] scene what is seen
 * \param[in] rig the pinhole; baselines play no part
 * \param[in] T_scene_camera place of the camera in the scene's frame
 * \param[in] reach largest depth z that is seen, metres
 * \throws BadArgumentException for a rig that cannot be or a reach that is not above 0
 * \ingroup simulation */
ACMAP_EXPORT SurfaceImage
castView(const SceneGeometry& scene,
         const TrinocularRig& rig,
         const Eigen::Isometry3d& T_scene_camera,
         double reach = std::numeric_limits<double>::infinity());

} // namespace pcl
