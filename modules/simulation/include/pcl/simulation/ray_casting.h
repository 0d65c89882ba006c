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

/** \brief Surfaces seen by the pixels of a view, row by row. It contains no colour and
 * no noise, so that a view is cast once and may be shaded many times.
 * \ingroup simulation */
struct SurfaceImage {
  int width = 0;                     ///< px
  int height = 0;                    ///< px
  std::vector<double> distance;      ///< metres along the unit ray, NaN for nothing
  std::vector<std::int32_t> surface; ///< index in the scene, -1 for nothing
};

/** \brief Direction of the viewing ray of a pixel, of unit length, in the camera frame.
 * \ingroup simulation */
ACMAP_EXPORT Eigen::Vector3d
pixelRay(const TrinocularRig& rig, int column, int row);

/** \brief Intersects the ray of each pixel with the scene, exactly: surfaces are
 * neither triangulated nor sampled.
 *
 * If several surfaces have the same distance, the first one in the scene is returned.
 * Surfaces outside the view are excluded first; the time for each other surface is
 * roughly proportional to its number of pixels. Runs in all threads of the caller's
 * arena (acmap::withThreads), with the same result for any number of threads.
 * \param[in] scene the surfaces
 * \param[in] rig pinhole model of the camera; baselines are ignored
 * \param[in] T_scene_camera pose of the camera in the scene's frame
 * \param[in] reach maximum depth z that is seen, metres
 * \throws BadArgumentException for an invalid rig or a reach that is not above 0
 * \ingroup simulation */
ACMAP_EXPORT SurfaceImage
castView(const SceneGeometry& scene,
         const TrinocularRig& rig,
         const Eigen::Isometry3d& T_scene_camera,
         double reach = std::numeric_limits<double>::infinity());

} // namespace pcl
