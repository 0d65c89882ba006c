#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/export.h>
#include <pcl/core/trajectory.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/simulation/depth_camera.h>
#include <pcl/simulation/scene_geometry.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief Model of the points that active stereo measures, without simulated images:
 * reach, number of points and noise. \ingroup simulation */
struct RangeSensor {
  double reach = 6.0; ///< metres, maximum depth z that is measured

  /** \brief Number of points of a view, if that many pixels see a surface in reach. */
  std::size_t points = 138653;

  /** \brief Number of first views with one additional point, to reach a given total. */
  std::size_t views_with_one_more = 0;

  double noise_growth = 0.0025; ///< 1/m; sigma is noise_growth * z^2 within bounds
  double min_noise = 0.01;      ///< metres, minimum of sigma
  double max_noise = 0.03;      ///< metres, maximum of sigma

  /** \brief Standard deviation along the ray, metres, at a depth z in metres. */
  ACMAP_EXPORT double
  sigma(double depth) const;

  std::size_t
  pointsOfView(std::size_t view) const
  {
    return points + (view < views_with_one_more ? 1 : 0);
  }
};

/** \brief A simulated building, the camera, and the camera's path through the building.
 * \ingroup simulation */
struct SimulatedScene {
  std::string name;
  SceneGeometry geometry;
  TrinocularRig rig;
  RangeSensor sensor;
  std::vector<Eigen::Isometry3d> views; ///< T_scene_camera, at least one

  /** \brief If set, this camera measures instead of \ref sensor. */
  std::optional<DepthCamera> depth_camera = std::nullopt;

  /** \brief Upper bound of the number of points of a view. */
  std::size_t
  mostPointsOfView() const
  {
    const std::size_t pixels =
        static_cast<std::size_t>(rig.width) * static_cast<std::size_t>(rig.height);
    return depth_camera ? pixels : std::min(sensor.points + 1, pixels);
  }
};

/** \brief Replaces the camera of a scene by a Kinect: the rig becomes \ref kinectRig,
 * and a \ref DepthCamera measures. \ingroup simulation */
ACMAP_EXPORT void
useKinect(SimulatedScene& scene);

/** \brief The poses of the first views in the map frame, which is the frame of the
 * first camera. Time stamps are one second apart.
 * \param[in] scene with its views
 * \param[in] views number of views
 * \throws BadArgumentException when the scene has fewer views, or the number is 0
 * \ingroup simulation */
ACMAP_EXPORT Trajectory
trajectoryOf(const SimulatedScene& scene, std::size_t views);

/** \brief The true planes in the map frame; each plane keeps its index.
 * \throws BadArgumentException for a scene without views \ingroup simulation */
ACMAP_EXPORT std::vector<TruthPlane>
planesInMap(const SimulatedScene& scene);

} // namespace pcl
