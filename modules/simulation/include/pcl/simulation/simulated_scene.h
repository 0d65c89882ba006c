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

/** \brief What active stereo measures, without its images: how far, how many points and
 * with what noise. \ingroup simulation */
struct RangeSensor {
  double reach = 6.0; ///< metres, largest depth z that is measured

  /** \brief Pixels of a view that get a point, if so many see something in reach. */
  std::size_t points = 138653;

  /** \brief The first views of the path keep one point more: so a total comes out. */
  std::size_t views_with_one_more = 0;

  double noise_growth = 0.0025; ///< 1/m: noise is this times z squared, but
  double least_noise = 0.01;    ///< metres, at least this
  double most_noise = 0.03;     ///< metres, at most this

  /** \brief One standard deviation along the ray, metres, at a depth z in metres. */
  ACMAP_EXPORT double
  sigma(double depth) const;

  std::size_t
  pointsOfView(std::size_t view) const
  {
    return points + (view < views_with_one_more ? 1 : 0);
  }
};

/** \brief A simulated building, the camera, and the way the camera takes through it.
 * \ingroup simulation */
struct SimulatedScene {
  std::string name;
  SceneGeometry geometry;
  TrinocularRig rig;
  RangeSensor sensor;
  std::vector<Eigen::Isometry3d> views; ///< T_scene_camera, at least one

  /** \brief Where it is set it measures, and \ref sensor does not. */
  std::optional<DepthCamera> depth_camera = std::nullopt;

  /** \brief No view has more points. */
  std::size_t
  mostPointsOfView() const
  {
    const std::size_t pixels =
        static_cast<std::size_t>(rig.width) * static_cast<std::size_t>(rig.height);
    return depth_camera ? pixels : std::min(sensor.points + 1, pixels);
  }
};

/** \brief Has the views of a scene be seen by a Kinect: its rig becomes \ref kinectRig, and
 * what measures a \ref DepthCamera. \ingroup simulation */
ACMAP_EXPORT void
useKinect(SimulatedScene& scene);

/** \brief The poses of the first views in the map frame, which is the frame of the first
 * camera; a second lies between two views.
 * \param[in] scene with its views
 * \param[in] views how many of them
 * \throws BadArgumentException when the scene has fewer views, or 0 are wanted
 * \ingroup simulation */
ACMAP_EXPORT Trajectory
trajectoryOf(const SimulatedScene& scene, std::size_t views);

/** \brief The true planes in the map frame; a plane keeps its index. \ingroup simulation
 */
ACMAP_EXPORT std::vector<TruthPlane>
planesInMap(const SimulatedScene& scene);

} // namespace pcl
