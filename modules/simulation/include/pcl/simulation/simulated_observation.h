#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/export.h>
#include <pcl/core/progress.h>
#include <pcl/simulation/ray_casting.h>
#include <pcl/simulation/simulated_scene.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {

/** \brief A pixel of a simulated observation, camera frame. \ingroup simulation */
struct ObservationPixel {
  float x, y, z;       ///< metres, NaN if nothing was measured
  std::uint32_t rgb;   ///< packed as PCL does (0x00rrggbb), valid at every pixel
  float sigma;         ///< metres, standard deviation along the ray, NaN as x y z
  std::uint32_t label; ///< true label: index of the measured plane + 1; 0 for none
};

/** \brief Measurement of the range sensor from one pose. \ingroup simulation */
struct SimulatedObservation {
  int width = 0;                        ///< px
  int height = 0;                       ///< px
  std::vector<ObservationPixel> pixels; ///< row by row
  std::size_t in_reach = 0; ///< number of pixels that see a surface in reach
  std::size_t points = 0;   ///< number of pixels that were measured
  bool has_sigma = true;    ///< true if the sensor reports its noise
};

/** \brief Measures a view: a random subset of the pixels that see a surface in reach
 * gets points with normally distributed noise along the ray; if the scene has a
 * \ref DepthCamera, this camera measures instead. Each pixel has its own random stream,
 * so that the result does not depend on order or threads.
 * \param[in] scene that was cast
 * \param[in] image of this view, cast at least up to the sensor's reach; surfaces
 * beyond it only contribute colour
 * \param[in] view its index in the scene
 * \param[in] seed of all random numbers
 * \throws BadArgumentException when the image does not match the view, or the scene's
 * depth camera is invalid
 * \ingroup simulation */
ACMAP_EXPORT SimulatedObservation
observe(const SimulatedScene& scene,
        const SurfaceImage& image,
        std::size_t view,
        std::uint64_t seed);

/** \brief Casts a view with unlimited reach and measures it. \ingroup simulation */
ACMAP_EXPORT SimulatedObservation
observe(const SimulatedScene& scene, std::size_t view, std::uint64_t seed);

/** \brief The observation as an organized cloud of x y z rgb sigma label; without sigma
 * if the sensor does not report it. \ingroup simulation */
ACMAP_EXPORT PCLPointCloud2
cloudOf(const SimulatedObservation& observation);

/** \brief All finite points of a sequence in the map frame, with ground truth. Points
 * are in the order of their views, and within a view in the order of their pixels.
 * \ingroup simulation */
struct MergedObservations {
  std::vector<Eigen::Vector3f> points; ///< metres
  std::vector<std::uint32_t> rgb;      ///< packed as in \ref ObservationPixel
  std::vector<std::int32_t> view;      ///< index in the trajectory
  std::vector<std::uint32_t> label;    ///< index in planes + 1, 0 for none
  Trajectory trajectory;               ///< T_map_camera
  std::vector<TruthPlane> planes;      ///< map frame
};

/** \brief Adds the finite points of an observation.
 * \param[in] observation in its camera's frame
 * \param[in] view index of its pose in the merged trajectory, which must exist
 * \param[in,out] merged receives the points \ingroup simulation */
ACMAP_EXPORT void
appendObservation(const SimulatedObservation& observation,
                  std::size_t view,
                  MergedObservations& merged);

/** \brief Measures the first views of a scene and merges them. The standard corridor
 * gives 14.7 million points, needs 0.4 GB, and takes a few seconds.
 * \param[in] scene to be measured
 * \param[in] views number of views; 0 for all
 * \param[in] seed of all random numbers
 * \param[in] progress called after each view
 * \throws BadArgumentException when the scene has fewer views
 * \throws CancelledException when the callback requested to stop \ingroup simulation */
ACMAP_EXPORT MergedObservations
mergeObservations(const SimulatedScene& scene,
                  std::size_t views,
                  std::uint64_t seed,
                  const ProgressCallback& progress = {});

/** \brief The merged points as a cloud of x y z rgb view label. \ingroup simulation */
ACMAP_EXPORT PCLPointCloud2
cloudOf(const MergedObservations& merged);

} // namespace pcl
