#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/planar_pose.h>
#include <pcl/mapping/impl/map_entropy_kernel.h>
#include <pcl/mapping/map_entropy_types.h>
#include <pcl/mapping/posed_clouds.h>
#include <pcl/memory.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace pcl {

/** \brief Measures how well observations fit together by the entropy of their map, Eq.
 * 3 of "Active Stereo Based Compact Mapping" (II-B.2),
 *
 * E = H(q_XZ) + mu (H(q_X) + H(q_Z)),
 *
 * where q_XZ is the share of points in each bin of the XZ plane (floor plan), smoothed
 * by a Gaussian of sigma_XZ, and q_X, q_Z are its sums along Z and along X. It is lower
 * the better the walls of the observations coincide, and the better they are aligned
 * with the axes.
 *
 * \ref compute and \ref computeGradient first aggregate the points of each observation
 * in cells of half a bin (or of one bin if it is filled evenly), which move with the
 * observation. Each cell is distributed over 3 x 3 bins by a quadratic B-spline, so
 * that E is continuously differentiable with respect to each pose. \ref computeExact
 * counts points in bins, as the paper does, and therefore has steps. The two differ by
 * at most (2 + 2 mu) log2 7 bits, with directions by log2 5 more, and by much less in
 * practice.
 *
 * With \ref setDirectionAware, points are also separated in layers by the direction of
 * their wall (eight directions of 45 degrees, by the normal, which is oriented towards
 * the sensor at the origin of the cloud), so that the two sides of a wall and crossing
 * walls do not attract each other. Points without a normal, and points of floors and
 * ceilings, share one further layer.
 *
 * Units are metres and radians; entropies are in bits. Poses transform from the frame
 * of the cloud (x right, y down, z forward) to that of the map. Bins begin at multiples
 * of their edge length, so that entropies under different poses are comparable. The
 * time is O(n) for n points to compute the cells once, then O(c + b) for c cells and
 * the b bins around them (and the same again for the gradient). The result is bitwise
 * the same for any number of threads.
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
class MapEntropy : public acmap::PosedClouds<PointT, PlanarPose, MapEntropyReport> {
  using Base = acmap::PosedClouds<PointT, PlanarPose, MapEntropyReport>;

public:
  using Ptr = shared_ptr<MapEntropy<PointT>>;
  using ConstPtr = shared_ptr<const MapEntropy<PointT>>;
  using typename Base::PointCloudConstPtr;

  /** \brief Adds an observation.
   * \param[in] cloud in the sensor's frame; it must not be changed afterwards; points
   * may be NaN
   * \param[in] pose of the sensor in the map
   * \param[in] weights weight of each point, for example the length of wall that a beam
   * represents; rounded to 2^-15 of the maximum. Empty: 1 each
   * \return its number
   * \throws BadArgumentException when the cloud is missing, x or z is not within [-1e9,
   * 1e9] m, theta is not within [-1e3, 1e3] rad, the number of weights differs from
   * that of the points, or a weight is not finite or negative */
  std::size_t
  addPointCloud(const PointCloudConstPtr& cloud,
                const PlanarPose& pose = {},
                const std::vector<float>& weights = {});

  /** \brief Removes all observations. */
  void
  clear();

  /** \brief Sets the edge length of a bin (default 0.1 m).
   * \throws BadArgumentException unless within [0.001, 100] m */
  void
  setBinSize(double metres);

  double
  getBinSize() const
  {
    return settings_.bin_size;
  }

  /** \brief Sets sigma_XZ, the standard deviation of the Gaussian (default 0.1 m; 0: no
   * smoothing).
   * \throws BadArgumentException unless within [0, 1000] m; the compute functions also
   * refuse more than 100 bins */
  void
  setSmoothing(double metres);

  double
  getSmoothing() const
  {
    return settings_.smoothing;
  }

  /** \brief Sets mu, the weight of H(q_X) + H(q_Z) (default 0.5). Use 0 for buildings
   * that are not parallel to the axes.
   * \throws BadArgumentException unless within [0, 1000] */
  void
  setProjectionWeight(double mu);

  double
  getProjectionWeight() const
  {
    return settings_.projection_weight;
  }

  /** \brief Separates walls of different directions (default false, as in the
   * paper). */
  void
  setDirectionAware(bool aware);

  bool
  getDirectionAware() const
  {
    return settings_.direction_aware;
  }

  /** \brief Computes the entropy of the map under the poses.
   * \return all 0, with the reason in the report, if no point is finite, a point is 1e9
   * m or more from its sensor, or the map needs more than 2^25 bins (all layers)
   * \throws InitFailedException without an observation
   * \throws BadArgumentException when the smoothing is wider than 100 bins
   * \throws CancelledException when the progress callback requested to stop */
  MapEntropyTerms
  compute();

  /** \brief Computes the entropy and its derivatives.
   * \param[out] gradient d total / d (x, z, theta) of each pose, in bits per metre and
   * bits per radian; zeros if there is no entropy
   * \throws as \ref compute */
  MapEntropyTerms
  computeGradient(std::vector<Eigen::Vector3d>& gradient);

  /** \brief Computes the entropy as in the paper: each point is counted in its bin,
   * without cells. This is slow.
   * \throws as \ref compute */
  MapEntropyTerms
  computeExact();

private:
  MapEntropyTerms
  evaluate(std::vector<Eigen::Vector3d>* gradient);

  void
  makeCells(const acmap::Progress& progress);

  acmap::PosedPoints
  viewOf(std::size_t number) const;

  void
  tellEmpty(MapEntropyReport& report) const;

  acmap::MapEntropySettings settings_;
  std::vector<acmap::EntropyCells> cells_; ///< cache; of the first observations
  std::optional<acmap::MapEntropyEvaluator> evaluator_; ///< cache; of all observations
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/mapping/impl/map_entropy.hpp>
#endif
