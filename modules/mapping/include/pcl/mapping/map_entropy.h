#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/planar_pose.h>
#include <pcl/core/stage_controls.h>
#include <pcl/mapping/map_entropy_kernel.h>
#include <pcl/mapping/map_entropy_types.h>
#include <pcl/memory.h>
#include <pcl/point_cloud.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace pcl {

/** \brief How well observations fit together: the entropy of their map, Eq. 3 of
 * "Active Stereo Based Compact Mapping" (II-B.2),
 *
 * E = H(q_XZ) + mu (H(q_X) + H(q_Z)),
 *
 * where q_XZ is the share of points in each bin of the XZ plane (floor plan),
 * smoothed by a Gaussian of sigma_XZ, and q_X, q_Z are its sums along Z and along X.
 * The better the observations' walls coincide, and the more they agree with the
 * axes, the lower it is.
 *
 * \ref compute and \ref computeGradient sum the points up in cells of half a bin, or of
 * a bin that they fill evenly, which move with their observation, and share each one
 * among 3 x 3 bins by a quadratic B-spline: E is continuously differentiable in every
 * pose. \ref computeExact counts points in bins, as the paper; it has steps. The two
 * differ by at most (2 + 2 mu) log2 7 bits, with directions by log2 5 more, and by much
 * less in practice.
 *
 * With \ref setDirectionAware a point also counts in a layer for the direction of
 * the wall it lies on (eight of 45 degrees, by its normal, turned to the sensor at
 * the origin of its cloud), so that the two sides of a wall and crossing walls do
 * not attract each other. Points without normal, and of floors and ceilings, share
 * one further layer.
 *
 * Metres, radians, entropies in bits. Poses lead from the cloud's frame (x right, y
 * down, z forward) into the map's. Bins begin at multiples of
 * their edge, so that entropies under different poses compare. Time O(n) for n points
 * when cells are made, once; then O(c + b) for c cells and the b bins around them (as
 * much, again, for the gradient). The same bytes for every number of threads.
 * \code
 * pcl::MapEntropy<pcl::PointXYZ> entropy;
 * for (std::size_t i = 0; i < clouds.size (); ++i)
 *   entropy.addPointCloud (clouds[i], poses[i]);   // PlanarPose {x, z, theta}
 * std::vector<Eigen::Vector3d> gradient;
 * const double bits = entropy.computeGradient (gradient).total;
 * \endcode
 * \ingroup mapping
 */
template <typename PointT>
class MapEntropy : public StageControls<MapEntropyReport> {
public:
  using Ptr = shared_ptr<MapEntropy<PointT>>;
  using ConstPtr = shared_ptr<const MapEntropy<PointT>>;
  using PointCloudConstPtr = typename PointCloud<PointT>::ConstPtr;

  /** \brief Adds an observation.
   * \param[in] cloud in the sensor's frame, not to be changed afterwards; points may
   * be NaN
   * \param[in] pose of the sensor in the map
   * \param[in] weights how much each point counts, say the length of wall that a beam
   * stands for; rounded to 2^-15 of the largest. Empty: 1 each
   * \return its number
   * \throws BadArgumentException when the cloud is missing, x or z is not within
   * [-1e9, 1e9] m or theta not within [-1e3, 1e3] rad, or weights are not as many as the
   * points, not finite or negative */
  std::size_t
  addPointCloud(const PointCloudConstPtr& cloud,
                const PlanarPose& pose = {},
                const std::vector<float>& weights = {});

  /** \brief Moves observation \a number; its cells stay.
   * \throws BadArgumentException as \ref addPointCloud, or when there is no such one */
  void
  setPose(std::size_t number, const PlanarPose& pose);

  /** \throws BadArgumentException when there is no such observation */
  const PlanarPose&
  getPose(std::size_t number) const;

  std::size_t
  getNumberOfPointClouds() const
  {
    return poses_.size();
  }

  /** \brief Takes all observations out. */
  void
  clear();

  /** \brief Sets the edge of a bin (default 0.1 m).
   * \throws BadArgumentException unless within [0.001, 100] m */
  void
  setBinSize(double metres);

  double
  getBinSize() const
  {
    return settings_.bin_size;
  }

  /** \brief Sets sigma_XZ, the standard deviation of the Gaussian (default 0.1 m; 0:
   * none).
   * \throws BadArgumentException unless within [0, 1000] m; the verbs also refuse
   * more than 100 bins */
  void
  setSmoothing(double metres);

  double
  getSmoothing() const
  {
    return settings_.smoothing;
  }

  /** \brief Sets mu, the weight of H(q_X) + H(q_Z) (default 0.5). 0 suits buildings
   * that are not parallel to the axes. \throws BadArgumentException unless within
   * [0, 1000] */
  void
  setProjectionWeight(double mu);

  double
  getProjectionWeight() const
  {
    return settings_.projection_weight;
  }

  /** \brief Keeps walls of different directions apart (default false: the paper). */
  void
  setDirectionAware(bool aware);

  bool
  getDirectionAware() const
  {
    return settings_.direction_aware;
  }

  /** \brief The entropy of the map under the poses.
   * \return all 0, and the report says why, where no point is finite, one is 1e9 m
   * from its sensor, or the map takes more than 2^25 bins (all layers)
   * \throws InitFailedException without an observation
   * \throws BadArgumentException when the smoothing is wider than 100 bins
   * \throws CancelledException when the progress callback stopped it */
  MapEntropyTerms
  compute();

  /** \brief The same, with its derivatives.
   * \param[out] gradient d total / d (x, z, theta) of each pose: bits a metre, bits a
   * radian; zeros where there is no entropy
   * \throws as \ref compute */
  MapEntropyTerms
  computeGradient(std::vector<Eigen::Vector3d>& gradient);

  /** \brief The entropy as the paper counts it: each point, in the bin it lies in.
   * No cell is used. Slow. \throws as \ref compute */
  MapEntropyTerms
  computeExact();

private:
  MapEntropyTerms
  evaluate(std::vector<Eigen::Vector3d>* gradient);

  void
  makeCells(const acmap::Progress& progress);

  acmap::PosedPoints
  viewOf(std::size_t number) const;

  acmap::MapEntropySettings settings_;
  std::vector<PointCloudConstPtr> clouds_;
  std::vector<PlanarPose> poses_;
  std::vector<std::vector<float>> weights_;
  std::vector<acmap::EntropyCells> cells_; ///< of the first observations; kept
  std::optional<acmap::MapEntropyEvaluator> evaluator_; ///< of all of them; kept
};

} // namespace pcl
