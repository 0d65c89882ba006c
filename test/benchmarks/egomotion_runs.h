#pragma once

#include "bench.h"

#include <pcl/core/point_types.h>
#include <pcl/core/trajectory_error.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/point_cloud.h>

#include <Eigen/Geometry>

#include <functional>
#include <optional>

namespace pcl::acmap::bench {

using EgomotionCloud = PointCloud<PointXYZRGBSigma>;

/** \brief Observations in temporal order, with their true poses. */
struct EgomotionSequence {
  std::string name;
  bool is_planar = false; ///< the camera keeps its height and does not tilt
  TrinocularRig camera;   ///< pinhole model of the clouds' pixels
  std::vector<EgomotionCloud::ConstPtr> clouds;
  std::vector<Eigen::Isometry3d> truth; ///< T_map_camera
};

/** \brief Simulates a drive through a standard scene with stereo matching of ten
 * patterns, and one shot without.
 * \param[in] grain of all walls, floors and ceilings, grey levels; none: the grain of
 * the scene (2)
 * \param[in] views maximum number of views */
EgomotionSequence
driveThrough(const std::string& scene,
             std::optional<double> grain = {},
             std::size_t views = 1000);

/** \brief Every tenth frame of a hand-held Kinect sequence (7-Scenes, RedKitchen), in
 * the frame of its colour camera; nothing, with a message, if the data are missing. */
std::optional<EgomotionSequence>
loadKitchen();

/** \brief A method that estimates the motion between two views of a sequence. */
struct EgomotionMethod {
  std::string name;

  /** \brief Returns T_target_source, on one thread; nothing if the method reports a
   * failure. */
  std::function<std::optional<Eigen::Isometry3d>(
      const EgomotionSequence& sequence, std::size_t source, std::size_t target)>
      motion;
};

/** \brief pcl::VisualEgomotion, which caches the last two views.
 * \param[in] refines also compares surfaces */
EgomotionMethod
oursMethod(bool refines);

/** \brief pcl::GeneralizedIterativeClosestPoint with identity as the initial guess, on
 * points up to 6 m depth, one per leaf of 5 cm.
 * \param[in] correspondence_distance maximum, metres
 * \param[in] neighbours used for the covariance of a point; PCL's default is 20 */
EgomotionMethod
gicpMethod(double correspondence_distance, int neighbours = 20);

/** \brief pcl::NormalDistributionsTransform with identity as the initial guess, on the
 * same points.
 * \param[in] resolution side of a cell, metres */
EgomotionMethod
ndtMethod(double resolution);

/** \brief Parameters of OpenCV's ORB and PnP. */
struct OrbSetting {
  int features = 2000;
  int fast_threshold = 20; ///< grey levels that define a corner
  double ratio = 0.8;      ///< best by second-best distance; 1: mutual best matches
  double tolerance = 3;    ///< pixels, of an inlier
  int min_inliers = 12;    ///< minimum number of inliers
};

/** \brief cv::ORB in both views with brute-force matching; the points of the target and
 * pixels of the source go to cv::solvePnPRansac, followed by a refinement with the
 * inliers. */
EgomotionMethod
orbMethod(const OrbSetting& setting = {});

/** \brief Motions estimated by a method between views of a sequence. */
struct EgomotionRun {
  std::string name;            ///< of the method
  std::size_t failures = 0;    ///< reported by the method
  std::size_t wrong = 0;       ///< not reported, with a large error: \ref isWrong
  RelativePoseError estimated; ///< of the motions that it returned
  RelativePoseError all;       ///< with identity instead of failed motions
  /** Errors of the chained motions, with identity for failures; NaN if they are not
   * chained. */
  AbsoluteTrajectoryError chain{no_reach, no_reach};
  std::vector<Eigen::Isometry3d> poses; ///< of the chain, starting with the true first
                                        ///< pose
  double seconds = 0;                   ///< mean CPU time per pair
};

/** \brief Is the error too large for any use? The limits are 10 cm and 5 degrees. */
bool
isWrong(const MotionError& error);

/** \brief Runs a method on neighbouring views, from later to earlier, and chains the
 * motions. For planar sequences only the planar part is evaluated. */
EgomotionRun
runChain(const EgomotionMethod& method, const EgomotionSequence& sequence);

/** \brief Runs a method on views with a given distance in the sequence, for at most 25
 * evenly distributed pairs; the motions are not chained. */
EgomotionRun
runApart(const EgomotionMethod& method,
         const EgomotionSequence& sequence,
         std::size_t step);

} // namespace pcl::acmap::bench
