#include "bag/sensor_mounting.h"

#include <pcl/core/exceptions.h>

#include <optional>
#include <utility>
#include <vector>

namespace pcl::acmap {

namespace {

constexpr const char* mounting_option = "--sensor-pose (BagSettings::T_robot_sensor)";

/** \brief camera of camera_link: what frames of the same device begin with. */
std::string
deviceOf(const std::string& frame)
{
  for (const char* ending : {"_link", "_frame", "_pose", "_odom"})
    if (endsWith(frame, ending))
      return frame.substr(0, frame.size() - std::string(ending).size());
  return frame;
}

bool
areOfOneDevice(const std::string& tracked, const std::string& sensor)
{
  const std::string device = deviceOf(tracked);
  return device.empty() || sensor.rfind(device + "_", 0) == 0 || sensor == device;
}

/** \brief Poses of a topic that does not name what has them. */
struct FramelessPoses {
  std::string topic;
  std::vector<RosTransform> poses;
};

/** \brief Finds where the sensor is on what moves. */
class Mounting {
public:
  Mounting(BagTopics& topics,
           const std::string& frame,
           bool is_camera,
           const BagSettings& settings)
  : topics_(topics)
  , frame_(frame)
  , root_(topics.tree().rootOf(frame))
  , is_camera_(is_camera)
  , settings_(settings)
  {
    const bool is_itself = !topics.tree().hasParent(frame);
    if (isOpticalFrame(root_) || (is_camera && is_itself))
      turn_ = cameraOfBody().inverse();
  }

  bool
  connect()
  {
    const std::string tracked = topics_.tree().trackedFrame(root_);
    const FramelessPoses found = framelessPoses();
    if (!found.poses.empty() && found.poses.size() >= topics_.tree().posesOf(tracked)) {
      takePoses(found);
      return true;
    }
    if (tracked.empty() && topics_.tree().posesOf(tracked) == 0)
      return false;
    mount(tracked, poseOn(tracked));
    return true;
  }

private:
  void
  mount(const std::string& parent, const Eigen::Isometry3d& T_parent_root)
  {
    RosTransform mounting;
    mounting.header.frame = parent;
    mounting.child = root_;
    mounting.T_parent_child = T_parent_root;
    topics_.tree().add(mounting, true);
  }

  /** \brief T_tracked_root */
  Eigen::Isometry3d
  poseOn(const std::string& tracked)
  {
    if (settings_.T_robot_sensor)
      return *settings_.T_robot_sensor * turn_;
    const bool is_same = areOfOneDevice(tracked, root_);
    if (is_camera_ && !is_same)
      topics_.fail("has no transform from " + tracked + ", which moves, to " + root_ +
                   of(frame_) + ", as without tf_static: state where it stands with " +
                   mounting_option + "; the frames are: " + topics_.tree().list());
    const bool turns = is_same && !isOpticalFrame(tracked);
    topics_.remark("assumed that " + root_ + " is at " +
                   (tracked.empty() ? "what the odometry tracks" : tracked) +
                   " and looks ahead, as there is no transform between them; " +
                   mounting_option + " states another place");
    return turns ? turn_ : Eigen::Isometry3d::Identity();
  }

  std::string
  of(const std::string& frame) const
  {
    return frame == root_ ? "" : ", the uppermost frame above " + frame;
  }

  /** \brief The most poses that a topic has; of paths, those of the last one, which has all
   * before. */
  FramelessPoses
  framelessPoses() const
  {
    FramelessPoses found;
    for (const char* type :
         {"geometry_msgs/PoseStamped", "geometry_msgs/PoseWithCovarianceStamped"})
      if (const BagTopic* const topic = topics_.largestOf(type);
          topic && topic->messages.size() > found.poses.size()) {
        found = {topic->name, {}};
        for (const BagMessage& message : topic->messages)
          found.poses.push_back(topics_.read(*topic, message, readRosPose));
      }
    for (const BagTopic* const topic : topics_.ofType("nav_msgs/Path")) {
      auto path = topics_.read(*topic, topic->messages.back(), readRosPath);
      if (path.size() > found.poses.size())
        found = {topic->name, std::move(path)};
    }
    return found;
  }

  /** \brief Takes poses without the name of a frame. */
  void
  takePoses(const FramelessPoses& found)
  {
    const std::string tracked = "pose of " + found.topic;
    for (RosTransform pose : found.poses) {
      pose.child = tracked;
      if (pose.header.frame == root_)
        pose.header.frame += " of poses";
      topics_.tree().add(pose, false);
    }
    topics_.tree().setTracked(tracked);
    if (settings_.T_robot_sensor)
      return mount(tracked, *settings_.T_robot_sensor * turn_);
    mount(tracked, Eigen::Isometry3d::Identity());
    topics_.remark("took the poses of " + found.topic + " as those of " + root_ + "; " +
                   mounting_option + " states where it is on what has these poses");
  }

  BagTopics& topics_;
  std::string frame_, root_; ///< of the sensor, and the uppermost one above it
  bool is_camera_;
  const BagSettings& settings_;
  Eigen::Isometry3d turn_ = Eigen::Isometry3d::Identity(); ///< from a body to the root
};

} // namespace

Eigen::Isometry3d
cameraOfBody()
{
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  return turn;
}

bool
isOpticalFrame(const std::string& frame)
{
  return endsWith(frame, "optical_frame") || endsWith(frame, "optical");
}

bool
connectSensor(BagTopics& topics,
              const std::string& frame,
              bool is_camera,
              const BagSettings& settings)
{
  if (settings.ignores_poses)
    return false;
  if (!topics.tree().moves(frame))
    return Mounting(topics, frame, is_camera, settings).connect();
  if (settings.T_robot_sensor)
    throw BadArgument("the place of the sensor is stated, but the transforms of " +
                      topics.bag().path() + " have it: " + topics.tree().list());
  return true;
}

} // namespace pcl::acmap
