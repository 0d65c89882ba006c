#pragma once

#include <pcl/core/export.h>
#include <pcl/core/trajectory_error.h>
#include <pcl/pipeline/visual_odometry.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {

/** \brief How far an odometry is from the truth. \ingroup pipeline */
struct OdometryComparison {
  std::vector<Eigen::Isometry3d>
      truth;                        ///< of all observations, in the map of the odometry
  RelativePoseError relative;       ///< from each posed observation to the next
  AbsoluteTrajectoryError absolute; ///< of the posed observations
  /** \brief Does the truth move, so that errors can be relative to its length? */
  bool is_moving = true;
};

/** \brief Compares the poses of an odometry with true ones. The first observation with a
 * pose has its true one. A camera that moved level is compared on the floor
 * (\ref absoluteTrajectoryError).
 * \param[in] truth T_world_camera of each observation, in any world, metres
 * \throws BadArgumentException unless there are as many as observations and one of these
 * has a pose \ingroup pipeline */
ACMAP_EXPORT OdometryComparison
compareWithTruth(const VisualOdometryResult& found,
                 std::vector<Eigen::Isometry3d> truth);

/** \brief What an odometry tells of itself, without a truth: medians over all pairs with a
 * motion. \ingroup pipeline */
struct OdometryFigures {
  double length = 0;    ///< of the path through all posed observations, metres
  double matches = 0;   ///< of a pair, by appearance
  double inliers = 0;   ///< of these, those that agree on its motion
  std::size_t fits = 0; ///< of all pairs
  /** \brief Estimated standard deviations of a motion: metres, radians. */
  double translation = 0, rotation = 0;
  double x = 0, z = 0, about_y = 0; ///< the same for each axis of a planar motion
};

/** \code
 * const pcl::OdometryFigures figures = pcl::figuresOf (odometry.compute (sequence));
 * std::cout << figures.length << " m, " << 1000 * figures.translation << " mm a pair\n";
 * \endcode
 * \return zeros if no pair has a motion \ingroup pipeline */
ACMAP_EXPORT OdometryFigures
figuresOf(const VisualOdometryResult& found);

/** \brief Reads one true pose for each observation, metres. If the number of rows differs
 * from that of the observations, rows are selected by the numbers in the names: rows that
 * are only in the same order might belong to other observations.
 * \param[in] path of a trajectory
 * \param[in] names of the observations
 * \param[in] scale metres in a unit of the trajectory
 * \param[out] remarks gets one if numbers were used
 * \throws InputFileException when the trajectory cannot be read, a name has no number, or an
 * observation has no row \ingroup pipeline */
ACMAP_EXPORT std::vector<Eigen::Isometry3d>
loadTruePoses(const std::string& path,
              const std::vector<std::string>& names,
              double scale,
              std::vector<std::string>& remarks);

} // namespace pcl
