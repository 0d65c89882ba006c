#pragma once

#include "rectification_runs.h"

#include <pcl/core/point_types.h>
#include <pcl/egomotion/revisit_detection_types.h>
#include <pcl/mapping/plane_adjustment.h>
#include <pcl/simulation/simulated_scene.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief All views of a scene, as organized clouds with sigma. */
struct AdjustmentScene {
  std::string name;
  std::vector<PointCloud<PointXYZRGBSigma>::Ptr> clouds; ///< metres, camera frames
  std::vector<Eigen::Isometry3d> truth;                  ///< T_scene_camera
};

/** \param[in] noise_seed of the noise of its points */
AdjustmentScene
makeAdjustmentScene(const SimulatedScene& scene, std::uint64_t noise_seed);

/** \brief Odometry in six degrees of freedom: of every action, each component of the
 * translation errs by a share of its length, and each of the rotation by an angle. */
struct FreeDrift {
  double level = 1;          ///< 1: 1 % and 0.2 degrees
  double turn_bias = 0;      ///< degrees about each axis, the same for each action
  bool heavy_tailed = false; ///< one action in ten errs five times as much
  double told = 1;           ///< factor on the noise that is told to the adjustment
};

/** \brief Poses from simulated odometry, starting with the true first pose. */
std::vector<Eigen::Isometry3d>
driftedFreely(const std::vector<Eigen::Isometry3d>& truth,
              const FreeDrift& drift,
              std::uint64_t seed);

/** \brief Result of an adjustment on one thread. */
struct AdjustmentRun {
  std::vector<Eigen::Isometry3d> found;
  PlaneAdjustmentReport report;
  double before = 0, after = 0;               ///< metres, ATE with the true first pose
  double height = 0;                          ///< metres, largest error along y
  double length_before = 0, length_after = 0; ///< percent, excess of first to last
  double seconds = 0;                         ///< CPU

  double
  ratio() const
  {
    return after / before;
  }
};

AdjustmentRun
adjust(const AdjustmentScene& scene,
       const std::vector<Eigen::Isometry3d>& given,
       const FreeDrift& drift,
       const std::vector<Revisit>& revisits = {});

/** \brief The same, and where it is refused after \ref EntropyRectification of the
 * consolidated observations, as the tools run both; errors before are those of the given
 * poses. */
AdjustmentRun
rectifyAndAdjust(const AdjustmentScene& scene,
                 const RectificationMap& map,
                 const std::vector<Eigen::Isometry3d>& given,
                 const FreeDrift& drift);

inline std::string
nameOf(AdjustmentOutcome outcome)
{
  return adjustment_outcome_names.at(static_cast<std::size_t>(outcome));
}

/** \brief Seeds of the drift: 11 to 20; the parameters were tuned with 1 to 6. The
 * environment variable ACMAP_DRIFT_SEEDS is a smaller number of them. */
std::vector<std::uint64_t>
driftSeeds();

} // namespace pcl::acmap::bench
