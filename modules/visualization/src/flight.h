#pragma once

#include "camera.h"

#include <pcl/core/trajectory.h>

#include <vector>

namespace pcl::acmap {

/** \brief The way along a trajectory, at the speed of who walks and looks about. */
class Flight {
public:
  /** \brief Poses that are not finite are left out. */
  explicit Flight(const Trajectory& trajectory);

  bool
  isEmpty() const
  {
    return poses_.empty();
  }

  /** \brief How long the whole way takes. */
  double
  seconds() const
  {
    return isEmpty() ? 0 : times_.back();
  }

  /** \brief The row of the trajectory reached last. */
  std::size_t
  rowAt(double time) const;

  /** \brief T_map_camera between the poses. */
  Eigen::Isometry3d
  poseAt(double time) const;

  /** \brief A steady eye behind and above the pose, which looks where it goes. Its depths
   * are not set. */
  Camera
  eyeAt(double time) const;

private:
  std::size_t
  legAt(double time) const;

  std::vector<Eigen::Isometry3d> poses_;
  std::vector<std::size_t> rows_; ///< of the poses in the trajectory
  std::vector<double> times_;     ///< at the poses, seconds
};

/** \brief What one sees from a pose, wide; the depths are not set. */
Camera
cameraAt(const Eigen::Isometry3d& T_map_camera);

} // namespace pcl::acmap
