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

  /** \brief Says that an odometry tells the pose of a frame, which may stand still. */
  void
  setTracked(const std::string& frame);

  /** \brief The uppermost frame above a frame; the frame itself if there is none. */
  std::string
  rootOf(const std::string& frame) const;

  /** \brief Does a frame move in its root? Frames of fixed mountings, which ROS 1 repeats
   * among those that move, do not. */
  bool
  moves(const std::string& frame) const;

  /** \brief The frame outside of a tree whose place in its parent changes most, as that of a
   * robot's base; wheels only turn. Empty if there is none.
   * \param[in] root of the tree */
  std::string
  trackedFrame(const std::string& root) const;

  /** \brief Number of the poses of a frame in its parent. */
  std::size_t
  posesOf(const std::string& frame) const;

  /** \brief All frames with their parents, for messages. */
  std::string
  list() const;

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
    bool is_tracked = false;                  ///< by an odometry
    Trajectory poses;                         ///< T_parent_child; one if it is fixed
    Eigen::AlignedBox3d places = {};          ///< of the poses
    bool is_constant = true;                  ///< are all poses the same?
    mutable std::optional<CameraPath> path{}; ///< made when it is needed

    bool
    moves() const
    {
      return !is_fixed && (is_tracked || !is_constant);
    }
  };

  /** \brief Pose in the parent at a time; nothing if it is not known near it. */
  static std::optional<Eigen::Isometry3d>
  poseAt(const Edge& edge, double stamp);

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
