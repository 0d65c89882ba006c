#pragma once

#include "rgbd/camera_path.h"

#include <pcl/core/ros_messages.h>
#include <pcl/core/trajectory.h>

#include <Eigen/Geometry>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief The frames of a robot as a tree, as ROS's tf has them. */
class FrameTree {
public:
  /** \brief Adds the pose of a frame in its parent. A frame keeps its first parent.
   * \param[in] is_fixed holds at all times */
  void
  add(const RosTransform& transform, bool is_fixed);

  bool
  hasParent(const std::string& frame) const;

  /** \brief The uppermost frame above a frame; the frame itself if there is none. */
  std::string
  rootOf(const std::string& frame) const;

  /** \brief Does a frame move in its root? */
  bool
  moves(const std::string& frame) const;

  /** \brief Pose of a frame in its root at a time; nothing if it is not known near it. */
  std::optional<Eigen::Isometry3d>
  poseInRoot(const std::string& frame, double stamp) const;

  /** \brief Pose of a frame in another one at a time, T_a_b, through the nearest frame above
   * both; nothing if there is none, or a pose is not known near the time. */
  std::optional<Eigen::Isometry3d>
  relativePose(const std::string& a, const std::string& b, double stamp) const;

private:
  struct Edge {
    std::string parent;
    bool is_fixed = false;
    Trajectory poses;                       ///< T_parent_child; one if it is fixed
    mutable std::optional<CameraPath> path; ///< made when it is needed
  };

  /** \brief A frame above another one, with the other's pose in it. */
  struct Ancestor {
    std::string frame;
    Eigen::Isometry3d T_ancestor_frame;
  };

  /** \brief The frame itself and those above it, as far as poses are known at a time.
   * \param[out] is_whole Does it end at the root? */
  std::vector<Ancestor>
  ancestorsOf(const std::string& frame, double stamp, bool& is_whole) const;

  std::map<std::string, Edge> edges_; ///< by child
};

} // namespace pcl::acmap
