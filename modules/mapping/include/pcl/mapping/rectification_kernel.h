#pragma once

#include <pcl/core/export.h>
#include <pcl/core/planar_pose.h>
#include <pcl/core/progress.h>
#include <pcl/mapping/entropy_rectification_types.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Settings of \ref rectify; see EntropyRectification. */
struct RectificationSettings {
  RectificationMode mode = RectificationMode::Guarded;
  double bin_size = 0.1;         ///< metres, of the finest level
  double entropy_weight = 1;     ///< times the weights of the levels
  double projection_weight = -1; ///< mu; negative: 0 guarded, 0.1 as the paper
  OdometryNoise odometry;
  std::uint64_t seed = 1;
};

/** \brief An observation, levelled: in a frame at the foot of its sensor whose y points
 * down in the map, so that its pose is planar. */
struct LevelledPoints {
  std::vector<Eigen::Vector3f> points;  ///< metres
  std::vector<Eigen::Vector3f> normals; ///< one a point, NaN: none; or empty
  std::vector<float> weights;           ///< one a point; empty: 1 each
  double sensor_height = 0;             ///< metres, y of the sensor
};

/** \brief The poses that fit observations together.
 * \param[in] poses one for each observation, in the order in which they were made
 * \param[out] report counts, evidence and remarks are added
 * \return as many poses; those given where the outcome is not Rectified
 * \throws BadArgumentException when poses and observations differ in number
 * \throws CancelledException when the progress was told to stop */
ACMAP_EXPORT std::vector<PlanarPose>
rectify(const std::vector<LevelledPoints>& observations,
        const std::vector<PlanarPose>& poses,
        const RectificationSettings& settings,
        const Progress& progress,
        EntropyRectificationReport& report);

} // namespace pcl::acmap
