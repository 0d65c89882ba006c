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
  float x, y, z;       ///< metres, NaN where nothing was measured
  std::uint32_t rgb;   ///< packed as PCL does (0x00rrggbb), valid at every pixel
  float sigma;         ///< metres, one standard deviation along the ray, NaN as x y z
  std::uint32_t label; ///< truth: index of the measured plane + 1; 0 for none
};

/** \brief What the range sensor saw from one pose. \ingroup simulation */
struct SimulatedObservation {
  int width = 0;                        ///< px
  int height = 0;                       ///< px
  std::vector<ObservationPixel> pixels; ///< row by row
  std::size_t in_reach = 0;             ///< pixels that see something in reach
  std::size_t points = 0;               ///< pixels that were measured
  bool has_sigma = true;                ///< whether the sensor tells its noise
};

/** \brief Measures a view: of the pixels that see something in reach a random part gets
 * a point, with normal noise along its ray; or as the scene's \ref DepthCamera does. Each
 * pixel has a random stream of its own, so that nothing depends on order or threads.
 * \param[in] scene that was cast
 * \param[in] image of this view, cast at least as far as the sensor reaches; what it sees
 * beyond gives colour only
 * \param[in] view its index in the scene
 * \param[in] seed of all randomness
 * \throws BadArgumentException when the image is not of such a view, or the scene's depth
 * camera cannot be
 * \ingroup simulation */
ACMAP_EXPORT SimulatedObservation
observe(const SimulatedScene& scene,
        const SurfaceImage& image,
        std::size_t view,
        std::uint64_t seed);

/** \brief Casts a view without limit and measures it. \ingroup simulation */
ACMAP_EXPORT SimulatedObservation
observe(const SimulatedScene& scene, std::size_t view, std::uint64_t seed);

/** \brief The observation as an organized cloud of x y z rgb sigma label; without sigma
 * where the sensor does not tell it. \ingroup simulation */
ACMAP_EXPORT PCLPointCloud2
cloudOf(const SimulatedObservation& observation);

/** \brief All finite points of a sequence in the map frame, with the truth. Points stand
 * in the order of their views, and of their pixels in a view. \ingroup simulation */
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
 * \param[in] view index of its pose in the merged trajectory, which must be there
 * \param[in,out] merged what is added to \ingroup simulation */
ACMAP_EXPORT void
appendObservation(const SimulatedObservation& observation,
                  std::size_t view,
                  MergedObservations& merged);

/** \brief Measures the first views of a scene and merges them; the standard corridor
 * takes 14.7 million points, 0.4 GB, and a few seconds.
 * \param[in] scene what is measured
 * \param[in] views how many; 0 for all
 * \param[in] seed of all randomness
 * \param[in] progress told after each view
 * \throws BadArgumentException when the scene has fewer views
 * \throws CancelledException when the callback asked to stop \ingroup simulation */
ACMAP_EXPORT MergedObservations
mergeObservations(const SimulatedScene& scene,
                  std::size_t views,
                  std::uint64_t seed,
                  const ProgressCallback& progress = {});

/** \brief The merged points as a cloud of x y z rgb view label. \ingroup simulation */
ACMAP_EXPORT PCLPointCloud2
cloudOf(const MergedObservations& merged);

} // namespace pcl
