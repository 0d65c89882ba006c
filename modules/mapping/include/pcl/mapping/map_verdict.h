#pragma once

#include <pcl/core/build_config.h>
#include <pcl/mapping/impl/map_verdict_kernel.h>
#include <pcl/mapping/map_verdict_types.h>
#include <pcl/mapping/posed_clouds.h>
#include <pcl/memory.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl {

/** \brief Tells whether poses of a map are better than the odometry from which they were
 * found, after the rectification of Section II-B.2 of "Active Stereo Based Compact Mapping".
 *
 * It makes an estimate of its own from scans and odometry, which never sees the poses to be
 * judged: successive scans are matched; the noise and the bias of the odometry are measured
 * by these matches; places that are seen again are joined where nothing else looks like them;
 * and trajectories are drawn from the posterior of all of this. The poses are *consistent* if
 * hardly any of these trajectories, taken for the truth, makes their error larger than that of
 * the odometry, and no part of them contradicts it; they are *contradicted* if nearly all do,
 * or if a part cannot be true; all else is *undetermined*.
 *
 * The observations are scans of a planar laser: all points are within 5 cm of the sensor's
 * height, and their order does not matter. Other observations are undetermined, with the
 * reason. Units are metres and radians. The time is O(n) for n scans, apart from a sparse
 * Cholesky factorization. The result is bitwise the same for any number of threads.
 * \code
 * pcl::MapVerdict<pcl::PointNormal> verdict;
 * for (std::size_t i = 0; i < scans.size (); ++i)
 *   verdict.addPointCloud (scans[i], odometry[i]);
 * verdict.setJudgedPoses (rectified);
 * verdict.compute ();
 * std::cout << "at most " << verdict.getReport ().e95 << " m off\n";
 * \endcode
 * \ingroup mapping */
template <typename PointT>
class MapVerdict : public acmap::RegisteredClouds<PointT, MapVerdictReport> {
public:
  using Ptr = shared_ptr<MapVerdict<PointT>>;
  using ConstPtr = shared_ptr<const MapVerdict<PointT>>;

  /** \brief Sets the poses to be judged, one an observation, in the map of the given ones
   * or any other one with the same vertical (default: the given ones).
   * \throws BadArgumentException when one is no rigid motion */
  void
  setJudgedPoses(const std::vector<Eigen::Isometry3d>& poses);

  const std::vector<Eigen::Isometry3d>&
  getJudgedPoses() const
  {
    return judged_;
  }

  /** \brief Sets what the odometry is assumed to err by; what is measured is told as a
   * multiple of it.
   * \throws BadArgumentException naming the value */
  void
  setOdometryNoise(const OdometryNoise& noise);

  const OdometryNoise&
  getOdometryNoise() const
  {
    return odometry_;
  }

  /** \brief Sets the up direction of the map (default -y).
   * \param[in] up in the map frame, of any length above 0
   * \throws BadArgumentException unless it is finite and not 0 */
  void
  setUpDirection(const Eigen::Vector3d& up);

  const Eigen::Vector3d&
  getUpDirection() const
  {
    return up_;
  }

  /** \brief Sets the seed of the drawn trajectories (default 1). */
  void
  setSeed(std::uint64_t seed)
  {
    seed_ = seed;
  }

  std::uint64_t
  getSeed() const
  {
    return seed_;
  }

  /** \brief Judges the poses.
   * \throws InitFailedException without an observation
   * \throws BadArgumentException unless the judged poses are one an observation
   * \throws CancelledException when the progress callback requested to stop */
  void
  compute();

private:
  std::vector<Eigen::Isometry3d> judged_;
  OdometryNoise odometry_;
  Eigen::Vector3d up_ = -Eigen::Vector3d::UnitY();
  std::uint64_t seed_ = 1;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/mapping/impl/map_verdict.hpp>
#endif
