#pragma once

#include <pcl/core/impl/point_view.h>
#include <pcl/core/planar_pose.h>
#include <pcl/core/planar_scan.h>
#include <pcl/core/random.h>
#include <pcl/core/sensor_view.h>
#include <pcl/core/trajectory_error.h>
#include <pcl/mapping/entropy_rectification.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/simulation/simulated_scene.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Observations with known true poses. */
struct RectificationMap {
  std::string name;
  std::vector<PointCloud<PointNormal>::Ptr> clouds; ///< metres, sensor frames
  std::vector<std::vector<float>> weights;          ///< one per point
  std::vector<PlanarPose> truth;
  double bin_size = 0.1; ///< metres, the tool's default for such observations

  void
  add(const PlanarScan& scan, const PlanarPose& pose);

  /** \brief Adds a view, consolidated at 6 cm, with bins of 5 cm. */
  void
  addView(const PointView& points, const SensorView& sensors, const PlanarPose& pose);
};

/** \brief The laser logs for which there are targets, about 200 scans of each; missing
 * ones are reported on stderr and skipped. */
std::vector<RectificationMap>
makeLogMaps();

/** \brief A long corridor that was not used during the development of the search. */
std::vector<RectificationMap>
makeLongLogMaps();

/** \brief All views of a scene, consolidated one by one; poses in the scene frame. */
RectificationMap
makeSceneMap(const SimulatedScene& scene);

/** \brief 40 views of an endless uniform corridor: the position along it is not
 * observable. */
SimulatedScene
bareCorridor();

/** \brief Odometry noise: standard deviations for an action of length l and turn
 * dtheta. */
struct DriftModel {
  double length = 0;            ///< metres, of dx and dz, for any action
  double length_per_metre = 0;  ///< added per metre of l
  double turn = 0;              ///< radians, for any action
  double turn_per_radian = 0;   ///< added per radian of |dtheta|
  double turn_bias = 0;         ///< radians, the same for each action
  double length_scale = 1;      ///< of each length
  bool is_heavy_tailed = false; ///< one action in ten has four times the noise
};

/** \brief Noise of a wheeled robot; level 1 is typical, other levels are factors. */
DriftModel
robotDrift(double level);

/** \brief Noise of a camera: 1 % of the length and 0.2 degrees from view to view. */
DriftModel
cameraDrift();

/** \brief Poses from simulated odometry, starting with the true first pose. */
std::vector<PlanarPose>
drifted(const std::vector<PlanarPose>& truth, const DriftModel& drift, Random& random);

std::vector<PlanarPose>
drifted(const std::vector<PlanarPose>& truth,
        const DriftModel& drift,
        std::uint64_t seed);

/** \brief Result of rectifying a map. */
struct RectificationRun {
  std::string name; ///< of the map, with level and seed
  std::vector<PlanarPose> given, found;
  AbsoluteTrajectoryError before, after; ///< with the true first pose
  EntropyRectificationReport report;
  double seconds = 0; ///< CPU

  double
  ratio() const
  {
    return after.unaligned / before.unaligned;
  }

  double
  alignedRatio() const
  {
    return after.aligned / before.aligned;
  }
};

using Rectification = EntropyRectification<PointNormal>;

/** \brief Rectifies a map on one thread.
 * \param[in] configure changes default settings */
RectificationRun
rectifyMap(const RectificationMap& map,
           const std::vector<PlanarPose>& given,
           const std::function<void(Rectification&)>& configure = {});

inline std::string
nameOf(RectificationOutcome outcome)
{
  return rectification_outcome_names.at(static_cast<std::size_t>(outcome));
}

/** \brief Poses in space. */
std::vector<Eigen::Isometry3d>
isometriesOf(const std::vector<PlanarPose>& poses);

/** \brief The planar parts of poses. */
std::vector<PlanarPose>
planarPartsOf(const std::vector<Eigen::Isometry3d>& poses);

/** \brief The rigid motion that a registration of PCL found. */
Eigen::Isometry3d
motionOf(const Eigen::Matrix4f& matrix);

} // namespace pcl::acmap::bench
