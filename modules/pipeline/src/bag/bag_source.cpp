#include "bag/frame_tree.h"
#include "rgbd/stamp_matching.h"

#include <pcl/core/bag_file.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/ros_messages.h>
#include <pcl/pipeline/observation_source.h>
#include <pcl/pipeline/rgbd_observation.h>
#include <pcl/pipeline/stage_store.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace pcl {

namespace acmap {

namespace {

/** \brief A topic with its messages in the order of the file. */
struct BagTopic {
  std::string name, type;
  std::vector<BagMessage> messages;
};

/** \brief Images of a topic, judged by the first one. */
struct ImageTopic {
  const BagTopic* topic = nullptr;
  bool is_depth = false;
  std::string frame;
  std::int32_t width = 0, height = 0; ///< pixels
};

bool
endsWith(const std::string& text, const std::string& ending)
{
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

/** \brief Image of sensor_msgs/msg/Image; empty for types of other packages. */
std::string
typeIn(const std::string& package, const std::string& type)
{
  return type.rfind(package + "/msg/", 0) == 0 ? type.substr(package.size() + 5) : "";
}

/** \brief The topic of the CameraInfo beside that of an image. */
std::string
cameraTopicOf(std::string topic)
{
  for (const char* transport : {"/compressed", "/compressedDepth"})
    if (endsWith(topic, transport))
      topic.resize(topic.size() - std::string(transport).size());
  return topic.substr(0, topic.rfind('/') + 1) + "camera_info";
}

/** \brief From a body with x ahead and z up to a camera. */
Eigen::Isometry3d
cameraOfBody()
{
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  return turn;
}

/** \brief Turns the points of a cloud. */
void
turnCloud(const Eigen::Matrix3f& turn, PCLPointCloud2& cloud)
{
  const std::size_t offset = findField(cloud, "x")->offset;
  for (std::size_t i = 0; i < rowsOf(cloud); ++i) {
    std::uint8_t* const place = &cloud.data[i * cloud.point_step + offset];
    Eigen::Vector3f point;
    std::memcpy(point.data(), place, sizeof point);
    point = (turn * point).eval();
    std::memcpy(place, point.data(), sizeof point);
  }
}

/** \brief An observation: its messages, time and pose. */
struct BagObservation {
  BagMessage depth;                ///< or the cloud
  std::optional<BagMessage> color; ///< of RGB-D images
  double stamp = 0;                ///< seconds
  Eigen::Isometry3d T_map_camera = Eigen::Isometry3d::Identity();
};

/** \brief Finds out what a bag has, and lists its observations. */
class BagSource : public ObservationSource {
public:
  BagSource(const std::string& path, std::size_t every)
  : bag_(path)
  {
    listTopics();
    takeTransforms();
    std::vector<ImageTopic> depths, colors;
    for (const auto& [name, topic] : topics_)
      if (std::optional<ImageTopic> images = imagesOf(topic))
        (images->is_depth ? depths : colors).push_back(*images);
    if (!depths.empty() && !colors.empty()) {
      takeImages(mostOf(depths), colors, every);
      if (depths.size() > 1 || colors.size() > 1)
        remark("took depths of " + depth_.name + ", colours of " + color_.name);
    }
    else
      takeClouds(every);
    takePoses();
  }

  std::string
  name() const override
  {
    return bag_.path();
  }

  std::string
  fingerprint() const override
  {
    return acmap::stateOfFile(bag_.path());
  }

  std::size_t
  size() const override
  {
    return observations_.size();
  }

  Trajectory
  trajectory() const override
  {
    Trajectory trajectory;
    for (const BagObservation& observation : observations_) {
      trajectory.stamps.push_back(observation.stamp);
      if (has_poses_)
        trajectory.poses.push_back(observation.T_map_camera);
    }
    return trajectory;
  }

  PointCloudFile
  load(std::size_t i) const override
  {
    const BagObservation& seen = observations_.at(i);
    PointCloudFile file;
    file.cloud = seen.color ? imagesAsCloud(seen) : loadCloud(seen);
    file.sensor_origin = seen.T_map_camera.translation().cast<float>();
    file.sensor_orientation =
        Eigen::Quaterniond(seen.T_map_camera.linear()).cast<float>().normalized();
    return file;
  }

  std::vector<std::string>
  remarks() const override
  {
    return remarks_;
  }

private:
  [[noreturn]] void
  fail(const std::string& fault) const
  {
    throw InputFileException(bag_.path() + ": " + fault);
  }

  void
  remark(const std::string& text)
  {
    remarks_.push_back(bag_.path() + ": " + text);
  }

  std::string
  placeOf(const std::string& topic) const
  {
    return bag_.path() + ": " + topic;
  }

  void
  listTopics()
  {
    for (const BagMessage& message : bag_.messages()) {
      const BagChannel& channel = bag_.channels()[message.channel];
      if (channel.encoding != "cdr")
        continue;
      BagTopic& topic = topics_[channel.topic];
      if (topic.messages.empty()) {
        topic.name = channel.topic;
        topic.type = channel.type;
      }
      if (topic.type == channel.type)
        topic.messages.push_back(message);
    }
  }

  RosImage
  loadImage(const std::string& type,
            const std::string& topic,
            const BagMessage& message) const
  {
    const std::string bytes = bag_.load(message);
    return type == "CompressedImage" ? readRosCompressedImage(bytes, placeOf(topic))
                                     : readRosImage(bytes, placeOf(topic));
  }

  /** \brief Nothing if the messages are no images, or of an encoding that is neither of
   * colours nor of depths. */
  std::optional<ImageTopic>
  imagesOf(const BagTopic& topic) const
  {
    const std::string type = typeIn("sensor_msgs", topic.type);
    if (type != "Image" && type != "CompressedImage")
      return {};
    const RosImage first = loadImage(type, topic.name, topic.messages.front());
    ImageTopic images{&topic, first.isDepth(), first.header.frame};
    if (images.is_depth) {
      const DepthImage depth = depthsOf(first, placeOf(topic.name));
      images.width = depth.width;
      images.height = depth.height;
      return images;
    }
    try {
      const RgbImage color = colorsOf(first, placeOf(topic.name));
      images.width = color.width;
      images.height = color.height;
      return images;
    }
    catch (const InputFileException&) {
      return {}; // of a camera that is of no use here, such as an infrared one
    }
  }

  static const ImageTopic&
  mostOf(const std::vector<ImageTopic>& topics)
  {
    return *std::max_element(
        topics.begin(), topics.end(), [](const ImageTopic& a, const ImageTopic& b) {
          return a.topic->messages.size() < b.topic->messages.size();
        });
  }

  /** \brief Poses of frames in frames. */
  void
  takeTransforms()
  {
    for (const auto& [name, topic] : topics_)
      if (typeIn("tf2_msgs", topic.type) == "TFMessage")
        for (const BagMessage& message : topic.messages)
          for (const RosTransform& transform :
               readRosTransforms(bag_.load(message), placeOf(name)))
            tree_.add(transform, endsWith(name, "tf_static"));
    std::set<std::string> known;
    for (const auto& [name, topic] : topics_) {
      if (typeIn("nav_msgs", topic.type) != "Odometry")
        continue;
      const std::string child =
          readRosOdometry(bag_.load(topic.messages.front()), placeOf(name)).child;
      if (tree_.hasParent(child) || !known.insert(child).second)
        continue;
      for (const BagMessage& message : topic.messages)
        tree_.add(readRosOdometry(bag_.load(message), placeOf(name)), false);
    }
  }

  RosCameraInfo
  cameraOf(const ImageTopic& images) const
  {
    const auto load = [&](const BagTopic& topic) {
      return readRosCameraInfo(bag_.load(topic.messages.front()), placeOf(topic.name));
    };
    const auto beside = topics_.find(cameraTopicOf(images.topic->name));
    if (beside != topics_.end() &&
        typeIn("sensor_msgs", beside->second.type) == "CameraInfo")
      return load(beside->second);
    for (const auto& [name, topic] : topics_)
      if (typeIn("sensor_msgs", topic.type) == "CameraInfo")
        if (RosCameraInfo info = load(topic); info.header.frame == images.frame)
          return info;
    fail("has no CameraInfo for " + images.topic->name + ", looked for " +
         cameraTopicOf(images.topic->name));
  }

  /** \brief Chooses the colours for depths, and their cameras. */
  void
  takeImages(const ImageTopic& depth,
             const std::vector<ImageTopic>& colors,
             std::size_t every)
  {
    std::vector<ImageTopic> same;
    for (const ImageTopic& color : colors)
      if (isRegistered(depth, color))
        same.push_back(color);
    const ImageTopic color = mostOf(same.empty() ? colors : same);
    const RosCameraInfo depth_camera = cameraOf(depth);
    cameras_.depth = depth_camera.pinhole;
    bool is_distorted = depth_camera.is_distorted;
    if (same.empty()) {
      const RosCameraInfo color_camera = cameraOf(color);
      is_distorted |= color_camera.is_distorted;
      cameras_.color = {color_camera.pinhole, poseOfColors(depth, color)};
    }
    depth_size_ = {depth.width, depth.height};
    color_size_ = {color.width, color.height};
    frame_ = depth.frame;
    depth_ = *depth.topic;
    color_ = *color.topic;
    if (is_distorted)
      remark("its images are taken as rectified, though CameraInfo has a distortion");
    pair(every);
  }

  static bool
  isRegistered(const ImageTopic& depth, const ImageTopic& color)
  {
    return depth.frame == color.frame && depth.width == color.width &&
           depth.height == color.height;
  }

  /** \brief T_depth_color */
  Eigen::Isometry3d
  poseOfColors(const ImageTopic& depth, const ImageTopic& color) const
  {
    const double stamp = readRosHeader(bag_.load(depth.topic->messages.front()),
                                       placeOf(depth.topic->name))
                             .stamp;
    const auto T_depth_color = tree_.relativePose(depth.frame, color.frame, stamp);
    if (!T_depth_color)
      fail("has no transform between the frames of depths and colours, " + depth.frame +
           " and " + color.frame);
    return *T_depth_color;
  }

  std::vector<double>
  stampsOf(const BagTopic& topic) const
  {
    std::vector<double> stamps;
    for (const BagMessage& message : topic.messages)
      stamps.push_back(readRosHeader(bag_.load(message), placeOf(topic.name)).stamp);
    return stamps;
  }

  /** \brief Messages in the order of their stamps. */
  std::vector<double>
  sortByStamps(BagTopic& topic) const
  {
    const std::vector<double> stamps = stampsOf(topic);
    std::vector<double> rising;
    std::vector<BagMessage> messages;
    for (const std::size_t i : risingOrder(stamps)) {
      rising.push_back(stamps[i]);
      messages.push_back(topic.messages[i]);
    }
    topic.messages = std::move(messages);
    return rising;
  }

  void
  pair(std::size_t every)
  {
    constexpr double max_gap = 0.02; // seconds, as for folders
    const std::vector<double> depth_stamps = sortByStamps(depth_),
                              color_stamps = sortByStamps(color_);
    const auto pairs = matchStamps(depth_stamps, color_stamps, max_gap);
    if (pairs.empty())
      fail("no image of " + color_.name + " was taken within 20 ms of one of " +
           depth_.name);
    if (pairs.size() < depth_stamps.size())
      remark(std::to_string(depth_stamps.size() - pairs.size()) +
             " depth images left out: no colour image was taken near them");
    for (std::size_t i = 0; i < pairs.size(); i += every)
      observations_.push_back({depth_.messages[pairs[i].first],
                               color_.messages[pairs[i].second],
                               depth_stamps[pairs[i].first],
                               Eigen::Isometry3d::Identity()});
  }

  void
  takeClouds(std::size_t every)
  {
    const BagTopic* most = nullptr;
    std::size_t topics = 0;
    for (const auto& [name, topic] : topics_) {
      if (typeIn("sensor_msgs", topic.type) != "PointCloud2")
        continue;
      ++topics;
      if (!most || topic.messages.size() > most->messages.size())
        most = &topic;
    }
    if (!most)
      fail("has neither depth images with colour images nor PointCloud2 among its " +
           std::to_string(topics_.size()) + " topics of CDR");
    depth_ = *most;
    if (topics > 1)
      remark("took clouds of " + depth_.name);
    const std::vector<double> stamps = sortByStamps(depth_);
    frame_ =
        readRosHeader(bag_.load(depth_.messages.front()), placeOf(depth_.name)).frame;
    if (!endsWith(frame_, "optical_frame") && !endsWith(frame_, "optical"))
      T_camera_frame_ = cameraOfBody();
    for (std::size_t i = 0; i < stamps.size(); i += every)
      observations_.push_back(
          {depth_.messages[i], std::nullopt, stamps[i], Eigen::Isometry3d::Identity()});
  }

  /** \brief Takes the poses of another topic as those of the sensor, if none is known by
   * its frame. */
  void
  takeOtherPoses()
  {
    const BagTopic* most = nullptr;
    for (const char* type : {"PoseStamped", "Odometry"})
      for (const auto& [name, topic] : topics_)
        if ((typeIn("geometry_msgs", topic.type) == type ||
             typeIn("nav_msgs", topic.type) == type) &&
            (!most || topic.messages.size() > most->messages.size()))
          most = &topic;
    if (!most)
      return;
    const std::string root = tree_.rootOf(frame_);
    for (const BagMessage& message : most->messages) {
      const std::string bytes = bag_.load(message);
      RosTransform pose = typeIn("nav_msgs", most->type) == "Odometry"
                              ? readRosOdometry(bytes, placeOf(most->name))
                              : readRosPose(bytes, placeOf(most->name));
      pose.child = root;
      if (pose.header.frame == root)
        pose.header.frame += " of poses";
      tree_.add(pose, false);
    }
    remark("took the poses of " + most->name + " as those of " + root);
  }

  void
  takePoses()
  {
    if (!tree_.moves(frame_))
      takeOtherPoses();
    if (!tree_.moves(frame_))
      return;
    const Eigen::Isometry3d T_frame_camera =
        cameras_.color ? cameras_.color->T_depth_color : T_camera_frame_.inverse();
    std::vector<BagObservation> posed;
    for (BagObservation& observation : observations_)
      if (const auto T_root_frame = tree_.poseInRoot(frame_, observation.stamp)) {
        observation.T_map_camera = *T_root_frame * T_frame_camera;
        posed.push_back(std::move(observation));
      }
    if (posed.empty())
      fail("has no pose of " + frame_ + " at the times of its observations");
    if (posed.size() < observations_.size())
      remark(std::to_string(observations_.size() - posed.size()) +
             " observations left out: no pose is known near them");
    observations_ = std::move(posed);
    const Eigen::Isometry3d T_first_root = observations_.front().T_map_camera.inverse();
    for (BagObservation& observation : observations_)
      observation.T_map_camera = T_first_root * observation.T_map_camera;
    observations_.front().T_map_camera.setIdentity();
    has_poses_ = true;
  }

  template <typename Image>
  void
  requireSize(const Image& image, const ImageSize& size, const BagTopic& topic) const
  {
    if (image.width != size.width || image.height != size.height)
      throw InputFileException(placeOf(topic.name) + ": has an image of " +
                               sizeText(image) + " pixels, the first one has " +
                               sizeText(size) + " pixels");
  }

  PCLPointCloud2
  imagesAsCloud(const BagObservation& seen) const
  {
    const auto load = [&](const BagTopic& topic, const BagMessage& message) {
      return loadImage(typeIn("sensor_msgs", topic.type), topic.name, message);
    };
    const DepthImage depth = depthsOf(load(depth_, seen.depth), placeOf(depth_.name));
    const RgbImage color = colorsOf(load(color_, *seen.color), placeOf(color_.name));
    requireSize(depth, depth_size_, depth_);
    requireSize(color, color_size_, color_);
    return makeRgbdObservation(
               color, measuredPoints(depth, cameras_.depth), depth_size_, cameras_)
        .cloud;
  }

  PCLPointCloud2
  loadCloud(const BagObservation& seen) const
  {
    RosCloud read = readRosCloud(bag_.load(seen.depth), placeOf(depth_.name));
    if (!T_camera_frame_.matrix().isIdentity(0))
      turnCloud(T_camera_frame_.linear().cast<float>(), read.cloud);
    return std::move(read.cloud);
  }

  BagFile bag_;
  std::map<std::string, BagTopic> topics_; ///< those of CDR, by name
  FrameTree tree_;
  BagTopic depth_, color_; ///< those that are taken; depth: or of clouds
  std::string frame_;      ///< of depths or clouds
  Eigen::Isometry3d T_camera_frame_ = Eigen::Isometry3d::Identity(); ///< of clouds
  RgbdCameras cameras_;
  ImageSize depth_size_, color_size_;
  std::vector<BagObservation> observations_;
  bool has_poses_ = false;
  std::vector<std::string> remarks_;
};

} // namespace

} // namespace acmap

std::shared_ptr<const ObservationSource>
openBag(const std::string& path, std::size_t every)
{
  if (every == 0)
    acmap::refuseArgument("every", every, "at least 1");
  return std::make_shared<acmap::BagSource>(path, every);
}

} // namespace pcl
