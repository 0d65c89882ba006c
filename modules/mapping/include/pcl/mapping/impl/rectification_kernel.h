#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/planar_pose.h>
#include <pcl/core/progress.h>
#include <pcl/mapping/entropy_rectification_types.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief Settings of \ref rectify; see EntropyRectification. */
struct RectificationSettings {
  RectificationMode mode = RectificationMode::Guarded;
  double bin_size = 0.1;                   ///< metres, of the finest level
  double entropy_weight = 1;               ///< factor of the weights of the levels
  std::optional<double> projection_weight; ///< mu; none: 0 (Guarded), 0.1 (Paper)
  std::optional<double> smoothing; ///< metres, sigma_XZ (Paper); none: the bin size
  OdometryNoise odometry;
  bool is_odometry_stated = false; ///< else Guarded measures it by planar scans
  std::uint64_t seed = 1;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const RectificationSettings& settings, Visitor&& visit)
{
  visit({"mode"}, Named{settings.mode, rectification_mode_names});
  visit({"bin_size", "m"}, settings.bin_size);
  visit({"entropy_weight"}, settings.entropy_weight);
  visit({"projection_weight"}, settings.projection_weight);
  visit({"smoothing", "m"}, settings.smoothing);
  visit({"odometry"}, settings.odometry);
  visit({"is_odometry_stated"}, settings.is_odometry_stated);
  visit({"seed"}, settings.seed);
}

/** \brief A levelled observation: its frame is below its sensor, and its y axis points
 * down in the map, so that its pose is planar. */
struct LevelledPoints {
  std::vector<Eigen::Vector3f> points;  ///< metres
  std::vector<Eigen::Vector3f> normals; ///< one per point, NaN: none; or empty
  std::vector<float> weights;           ///< one per point; empty: 1 each
  double sensor_height = 0;             ///< metres, y of the sensor
};

/** \brief Height and tilt of a pose: the transformation from the sensor's frame to the
 * levelled one. T_map_camera is isometryOf (planarPartOf (T_map_camera)) times this. */
ACMAP_EXPORT Eigen::Isometry3d
levelOf(const Eigen::Isometry3d& T_map_camera);

/** \brief Transforms an observation to its levelled frame.
 * \param[in] points metres, sensor's frame
 * \param[in] normals of the same points; empty: none
 * \param[in] weights one per point; empty: 1 each */
ACMAP_EXPORT LevelledPoints
levelledPoints(const PointView& points,
               const PointView& normals,
               const Eigen::Isometry3d& T_map_camera,
               const std::vector<float>& weights);

/** \brief Computes the poses under which the observations fit together.
 * \param[in] poses one per observation, in the order in which they were made
 * \param[out] report counts, evidence and remarks are added
 * \return as many poses; the given ones if the outcome is not Rectified
 * \throws BadArgumentException when poses and observations differ in number
 * \throws CancelledException when the progress callback requested to stop */
ACMAP_EXPORT std::vector<PlanarPose>
rectify(const std::vector<LevelledPoints>& observations,
        const std::vector<PlanarPose>& poses,
        const RectificationSettings& settings,
        const Progress& progress,
        EntropyRectificationReport& report);

} // namespace pcl::acmap
