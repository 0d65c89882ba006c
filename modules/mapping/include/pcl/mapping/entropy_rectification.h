#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/stage_controls.h>
#include <pcl/mapping/entropy_rectification_types.h>
#include <pcl/mapping/rectification_kernel.h>
#include <pcl/memory.h>
#include <pcl/point_cloud.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace pcl {

/** \brief Straightens a map: finds the poses of observations under which their points
 * fit together best, without matching any of them, as in II-B.2 of
 * "Active Stereo Based Compact Mapping". In the shape of PCL's registration::LUM.
 *
 * Guarded mode (default) minimises F = kappa N (E - E_wide) + |u|^2 / 2. E is the
 * direction-aware entropy of \ref MapEntropy, E_wide the same in bins four times as wide:
 * entropy alone also falls when a map shrinks, the difference does not. u are the actions'
 * residuals against the odometry in sigmas. By gradient descent, from windows of 16
 * observations to the whole map, coarse to fine, kappa from small to large. Candidates
 * are then judged by what entropy does not use: rays that pass through walls which others
 * have seen. If they speak against all of them, or the given map was as good, the poses
 * stay and the report says so.
 *
 * Paper mode minimises Eq. 3 alone, E = H(q_XZ) + mu (H(q_X) + H(q_Z)), along the
 * building's main directions, by voting on random subsets of actions; the energy never
 * rises at a bin size. It has no guard.
 *
 * Poses move in the XZ plane (y is the vertical) and turn about y; heights and tilts
 * stay. Normals should be given (\ref VoxelConsolidation makes them); their side is
 * taken from the sensor. Metres, radians. Time: O(n) once for n points, then some hundred
 * evaluations of the entropy, each O(cells + bins). The same bytes for every number of
 * threads.
 * \code
 * pcl::EntropyRectification<pcl::PointNormal> rectification;
 * for (std::size_t i = 0; i < clouds.size (); ++i)
 *   rectification.addPointCloud (clouds[i], T_map_camera[i]);
 * rectification.compute ();
 * if (rectification.getReport ().outcome == pcl::RectificationOutcome::Rectified)
 *   pcl::io::savePCDFileBinary ("map.pcd", *rectification.getConcatenatedCloud ());
 * \endcode
 * \ingroup mapping
 */
template <typename PointT>
class EntropyRectification : public StageControls<EntropyRectificationReport> {
public:
  using Ptr = shared_ptr<EntropyRectification<PointT>>;
  using ConstPtr = shared_ptr<const EntropyRectification<PointT>>;
  using PointCloud = pcl::PointCloud<PointT>;
  using PointCloudPtr = typename PointCloud::Ptr;
  using PointCloudConstPtr = typename PointCloud::ConstPtr;

  /** \brief Adds an observation, in the order in which they were made.
   * \param[in] cloud in the sensor's frame, not to be changed afterwards; points may
   * be NaN
   * \param[in] pose T_map_camera
   * \param[in] weights how much each point counts, as in \ref MapEntropy; empty: 1
   * \return its number
   * \throws BadArgumentException when the cloud is missing, the pose no rigid motion,
   * or the weights are not one a point, finite and >= 0 */
  std::size_t
  addPointCloud(const PointCloudConstPtr& cloud,
                const Eigen::Isometry3d& pose,
                const std::vector<float>& weights = {});

  /** \brief Sets the pose from which \ref compute starts.
   * \throws BadArgumentException as \ref addPointCloud, or when there is no such one */
  void
  setPose(std::size_t number, const Eigen::Isometry3d& pose);

  /** \brief T_map_camera: rectified after \ref compute, as it came before it. */
  const Eigen::Isometry3d&
  getPose(std::size_t number) const;

  std::size_t
  getNumberOfPointClouds() const
  {
    return clouds_.size();
  }

  /** \brief Takes all observations out. */
  void
  clear();

  /** \brief Sets how to search (default Guarded). */
  void
  setMode(RectificationMode mode)
  {
    settings_.mode = mode;
  }

  RectificationMode
  getMode() const
  {
    return settings_.mode;
  }

  /** \brief Sets the edge of the finest bins (default 0.1 m); the search begins with
   * four times that. \throws BadArgumentException unless within [0.001, 25] m */
  void
  setBinSize(double metres);

  double
  getBinSize() const
  {
    return settings_.bin_size;
  }

  /** \brief Sets how much a bit of entropy counts against the odometry, times the
   * default. \throws BadArgumentException unless within [1e-3, 1e3] */
  void
  setEntropyWeight(double factor);

  double
  getEntropyWeight() const
  {
    return settings_.entropy_weight;
  }

  /** \brief Sets mu, the weight of H(q_X) + H(q_Z) along the building's main directions
   * (default: 0.1 in Paper mode, 0 in Guarded mode, where it does harm in buildings that
   * are not plane-parallel). \throws BadArgumentException unless within [0, 1000] */
  void
  setProjectionWeight(double mu);

  /** \brief mu as set; negative: by the mode. */
  double
  getProjectionWeight() const
  {
    return settings_.projection_weight;
  }

  /** \brief Sets what the odometry is expected to err by. If the rays say so twice or four
   * times as much is allowed for. \throws BadArgumentException naming the value */
  void
  setOdometryNoise(const OdometryNoise& noise);

  const OdometryNoise&
  getOdometryNoise() const
  {
    return settings_.odometry;
  }

  /** \brief Sets the seed of the voting (Paper mode; default 1). */
  void
  setSeed(std::uint64_t seed)
  {
    settings_.seed = seed;
  }

  std::uint64_t
  getSeed() const
  {
    return settings_.seed;
  }

  /** \brief Rectifies the poses, beginning with those that were given, whatever an
   * earlier run has found.
   * \throws InitFailedException without an observation
   * \throws CancelledException when the progress callback stopped it; nothing changes */
  void
  compute();

  /** \brief \ref getPose as PCL's transformations. */
  Eigen::Affine3f
  getTransformation(std::size_t number) const;

  /** \brief An observation in the map. */
  PointCloudPtr
  getTransformedCloud(std::size_t number) const;

  /** \brief All observations in the map. */
  PointCloudPtr
  getConcatenatedCloud() const;

private:
  acmap::RectificationSettings settings_;
  std::vector<PointCloudConstPtr> clouds_;
  std::vector<std::vector<float>> weights_;
  std::vector<Eigen::Isometry3d> given_, poses_;
};

} // namespace pcl
