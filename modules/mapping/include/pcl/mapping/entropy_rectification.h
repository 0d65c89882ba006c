#pragma once

#include <pcl/core/build_config.h>
#include <pcl/mapping/entropy_rectification_types.h>
#include <pcl/mapping/impl/levelling_kernel.h>
#include <pcl/mapping/impl/rectification_kernel.h>
#include <pcl/mapping/posed_clouds.h>
#include <pcl/memory.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl {

/** \brief Rectifies a map: finds the poses of observations under which their points
 * fit together best, without correspondences. Section II-B.2 of
 * "Active Stereo Based Compact Mapping". In the shape of PCL's registration::LUM, and a
 * Filter, which makes one cloud of all.
 *
 * Guarded mode (default) minimises F = kappa N (E - E_wide) + u^T C^-1 u / 2. E is the
 * direction-aware entropy of \ref MapEntropy, E_wide is the same in bins four times as
 * wide: the entropy alone also decreases when a map shrinks, the difference does not. u
 * are the residuals of the actions against the odometry, in standard deviations, which
 * are independent but for an error that all turns have in common. The minimisation
 * uses L-BFGS, from windows of 16 observations to the whole map, from
 * coarse to fine, with increasing kappa. The candidates are then verified by
 * evidence that the entropy does not use: rays that pass through walls seen by other
 * observations. If the rays contradict all candidates, or if the given map was as good,
 * the poses are unchanged and the report contains the reason.
 *
 * Paper mode minimises Eq. 3 alone, E = H(q_XZ) + mu (H(q_X) + H(q_Z)), along the main
 * directions of the building, with each given point counted in its bin, by voting: each
 * vote changes a random subset of the actions at once, each action in proportion to the
 * effect of its previous changes on the energy, and is accepted if the energy decreases.
 * This mode has no verification.
 *
 * Poses are translated in the XZ plane (y is vertical, unless another direction is set)
 * and rotated about y; heights and tilts are unchanged. \ref MapLevelling finds the
 * vertical. Normals should be given (\ref VoxelConsolidation computes them);
 * they are oriented towards the sensor. Units are metres and radians. The time is O(n)
 * once for n points, plus some hundred evaluations of the entropy, each O(cells +
 * bins); in Paper mode 50 evaluations per observation, each O(n + bins). The result is
 * bitwise the same for any number of threads.
 * \code
 * pcl::EntropyRectification<pcl::PointNormal> rectification;
 * for (std::size_t i = 0; i < clouds.size (); ++i)
 *   rectification.addPointCloud (clouds[i], T_map_camera[i]);
 * rectification.compute ();
 * if (rectification.getReport ().outcome == pcl::RectificationOutcome::Rectified)
 *   pcl::io::savePCDFileBinary ("map.pcd", *rectification.getConcatenatedCloud ());
 * \endcode
 * With poses that are in the clouds, as in PCD files with a VIEWPOINT:
 * \code
 * for (const auto& cloud : clouds) {
 *   rectification.setInputCloud (cloud);
 *   rectification.addPointsFromInputCloud ();
 * }
 * pcl::PointCloud<pcl::PointNormal> map;
 * rectification.filter (map);
 * \endcode
 * \ingroup mapping
 */
template <typename PointT>
class EntropyRectification
: public acmap::RegisteringFilter<PointT, EntropyRectificationReport> {
public:
  using Ptr = shared_ptr<EntropyRectification<PointT>>;
  using ConstPtr = shared_ptr<const EntropyRectification<PointT>>;

  /** \brief Sets the search mode (default Guarded). */
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

  /** \brief Sets the edge length of the finest bins (default 0.1 m); the search in
   * Guarded mode begins with four times this value, Paper mode uses only these.
   * \throws BadArgumentException unless within [0.001, 25] m */
  void
  setBinSize(double metres);

  double
  getBinSize() const
  {
    return settings_.bin_size;
  }

  /** \brief Sets the weight of the entropy against the odometry, as a factor of the
   * default.
   * \throws BadArgumentException unless within [1e-3, 1e3] */
  void
  setEntropyWeight(double factor);

  double
  getEntropyWeight() const
  {
    return settings_.entropy_weight;
  }

  /** \brief Sets mu, the weight of H(q_X) + H(q_Z) along the main directions of the
   * building (default: 0.1 in Paper mode; 0 in Guarded mode, because it is harmful in
   * buildings that are not plane-parallel).
   * \throws BadArgumentException unless within [0, 1000] */
  void
  setProjectionWeight(double mu);

  /** \brief mu as it was set; nothing: the default of the mode. */
  const std::optional<double>&
  getProjectionWeight() const
  {
    return settings_.projection_weight;
  }

  /** \brief Sets sigma_XZ, the standard deviation of the Gaussian, in Paper mode
   * (default: the bin size; 0: no smoothing). Guarded mode always smooths by one bin of
   * each of its levels.
   * \throws BadArgumentException unless within [0, 1000] m; \ref compute also refuses
   * more than 100 bins */
  void
  setSmoothing(double metres);

  /** \brief sigma_XZ as it was set, metres; nothing: the bin size. */
  const std::optional<double>&
  getSmoothing() const
  {
    return settings_.smoothing;
  }

  /** \brief Sets the expected errors of the odometry. If the rays indicate it, twice or
   * four times as much is permitted.
   * \throws BadArgumentException naming the value */
  void
  setOdometryNoise(const OdometryNoise& noise);

  const OdometryNoise&
  getOdometryNoise() const
  {
    return settings_.odometry;
  }

  /** \brief Was it set, and not only left as it is by default? */
  bool
  hasOdometryNoise() const
  {
    return settings_.is_odometry_stated;
  }

  /** \brief Sets the up direction of the map: poses are translated perpendicularly to it
   * and rotated about it (default: found by floors and walls, as MapLevelling does it;
   * if these show none, -y or z, whichever the sensors suggest, with a remark).
   * \param[in] up in the map frame, of any length above 0
   * \throws BadArgumentException if it is not finite or zero */
  void
  setUpDirection(const Eigen::Vector3d& up);

  /** \brief The up direction that was set, of length 1; nothing if it is found. */
  const std::optional<Eigen::Vector3d>&
  getUpDirection() const
  {
    return up_;
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

  /** \brief Rectifies the poses, always starting from the given ones, regardless of
   * earlier results.
   * \throws InitFailedException without an observation
   * \throws BadArgumentException when sigma_XZ exceeds 100 bins (Paper mode)
   * \throws CancelledException when the progress callback requested to stop; nothing is
   * changed */
  void
  compute() override;

  /** \brief All settings but the up direction. */
  const acmap::RectificationSettings&
  settings() const
  {
    return settings_;
  }

private:
  /** Of all observations, unless the up direction was set. */
  std::vector<acmap::ObservedSurface>
  surfaces() const;

  acmap::RectificationSettings settings_;
  std::optional<Eigen::Vector3d> up_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/mapping/impl/entropy_rectification.hpp>
#endif
