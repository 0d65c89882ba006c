#pragma once

#include "camera.h"

#include <pcl/core/trajectory.h>

#include <vector>

namespace pcl::acmap {

/** \brief A camera flight along a trajectory, limited in speed and rotation. */
class Flight {
public:
  /** \brief Poses that are not finite are left out. */
  explicit Flight(const Trajectory& trajectory);

  bool
  isEmpty() const
  {
    return poses_.empty();
  }

  /** \brief Duration of the flight. */
  double
  seconds() const
  {
    return isEmpty() ? 0 : times_.back();
  }

  /** \brief Index in the trajectory of the last pose that was passed. */
  std::size_t
  rowAt(double time) const;

  /** \brief T_map_camera, interpolated between the poses. */
  Eigen::Isometry3d
  poseAt(double time) const;

  /** \brief Smoothed camera behind and above the pose, which looks ahead. Its clipping
   * range is not set. */
  Camera
  eyeAt(double time) const;

private:
  std::size_t
  legAt(double time) const;

  std::vector<Eigen::Isometry3d> poses_;
  std::vector<std::size_t> rows_; ///< indices of the poses in the trajectory
  std::vector<double> times_;     ///< times of the poses, seconds
};

/** \brief Camera at a pose, with a wide angle; its clipping range is not set. */
Camera
cameraAt(const Eigen::Isometry3d& T_map_camera);

} // namespace pcl::acmap
