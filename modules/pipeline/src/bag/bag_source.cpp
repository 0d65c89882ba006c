#include "bag/sensor_mounting.h"
#include "rgbd/stamp_matching.h"

#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/pipeline/observation_source.h>
#include <pcl/pipeline/rgbd_observation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

namespace pcl {

namespace acmap {

namespace {

constexpr const char *image_type = "sensor_msgs/Image",
                     *compressed_type = "sensor_msgs/CompressedImage",
                     *camera_type = "sensor_msgs/CameraInfo",
                     *cloud_type = "sensor_msgs/PointCloud2";

/** \brief Types of clouds and depths that are not read, and what makes of them one that is.
 */
constexpr std::array<std::pair<const char*, const char*>, 5> conversions = {
    {{"sensor_msgs/PointCloud",
      "rosrun point_cloud_converter point_cloud_converter_node publishes PointCloud2"},
     {"velodyne_msgs/VelodyneScan",
      "the node velodyne_pointcloud transform publishes PointCloud2"},
     {"ouster_ros/PacketMsg", "the node os_cloud of ouster_ros publishes PointCloud2"},
     {"livox_ros_driver/CustomMsg",
      "record livox_ros_driver with xfer_format 0, PointCloud2"},
     {"livox_ros_driver2/CustomMsg",
      "record livox_ros_driver2 with xfer_format 0, PointCloud2"}}};

/** \brief Images of a topic, judged by the first one. */
struct ImageTopic {
  const BagTopic* topic = nullptr;
  bool is_depth = false;
  bool is_gray = false; ///< as those of an infrared camera
  std::string frame;
  std::int32_t width = 0, height = 0; ///< pixels
};

/** \brief /device_0/sensor_0/Depth_0 of the images that RealSense's own recorder writes; empty
 * for others. All its frames are named 0. */
std::string
realsenseStreamOf(const std::string& topic)
{
  const std::string ending = "/image/data";
  const bool is_one = topic.rfind("/device_", 0) == 0 && endsWith(topic, ending);
  return is_one ? topic.substr(0, topic.size() - ending.size()) : std::string();
}

/** \brief The topic of the CameraInfo beside that of an image, or as RealSense's own
 * recorder has it. */
std::string
cameraTopicOf(std::string topic)
{
  for (const char* transport : {"/compressed", "/compressedDepth"})
    if (endsWith(topic, transport))
      topic.resize(topic.size() - std::string(transport).size());
  if (const std::string stream = realsenseStreamOf(topic); !stream.empty())
    return stream + "/info/camera_info";
  return topic.substr(0, topic.rfind('/') + 1) + "camera_info";
}

/** \brief Are the images of a topic infrared ones, whose 16 bits are no depths? */
bool
isInfrared(const std::string& topic)
{
  for (const char* name : {"/ir/", "/ir_", "_ir", "infra", "Infra"})
    if (topic.find(name) != topic.npos)
      return true;
  return false;
}

/** \brief Are both the same camera within 1 %? */
bool
areSame(const Pinhole& a, const Pinhole& b)
{
  const auto near = [&](double x, double y) { return std::abs(x - y) < 0.01 * a.fx; };
  return near(a.fx, b.fx) && near(a.fy, b.fy) && near(a.cx, b.cx) && near(a.cy, b.cy);
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
  BagSource(const std::string& path, const BagSettings& settings)
  : topics_(path)
  {
    std::vector<ImageTopic> depths, colors;
    for (const auto& [name, topic] : topics_.all())
      if (std::optional<ImageTopic> images = imagesOf(topic))
        (images->is_depth ? depths : colors).push_back(*images);
    preferColors(colors);
    if (!depths.empty() && !colors.empty()) {
      takeImages(bestDepths(depths, colors), colors, settings.every);
      if (depths.size() > 1 || colors.size() > 1)
        topics_.remark("took depths of " + depth_.name + ", colours of " + color_.name);
    }
    else if (const BagTopic* const clouds = topics_.largestOf(cloud_type))
      takeClouds(*clouds, settings.every);
    else
      refuseBag(depths);
    takePoses(settings);
  }

  std::string
  name() const override
  {
    return topics_.bag().path();
  }

  std::string
  fingerprint() const override
  {
    return topics_.fingerprint();
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
    return topics_.remarks();
  }

private:
  /** \brief Refuses a bag without observations, and names what reads it. */
  [[noreturn]] void
  refuseBag(const std::vector<ImageTopic>& depths) const
  {
    const std::string& path = name();
    if (topics_.largestOf(scan_type))
      topics_.fail("has laser scans of a plane: run pcl_entropy_rectification " + path +
                   " -o straight; its topics: " + topics_.list());
    std::string fault =
        depths.empty()
            ? "has neither depth images with colour images nor PointCloud2"
            : "has depth images in " + depths.front().topic->name +
                  ", but no colours: depth_image_proc's point_cloud_xyz publishes "
                  "PointCloud2";
    if (depths.empty() && topics_.ofType("sensor_msgs/Image").size() > 1)
      fault += "; of a stereo pair, stereo_image_proc publishes PointCloud2";
    for (const std::string& reason : unused_)
      fault += "; " + reason;
    for (const auto& [type, advice] : conversions)
      if (topics_.largestOf(type))
        fault += std::string("; ") + type + " is not read: " + advice;
    topics_.fail(fault + "; its topics: " + topics_.list());
  }

  RosImage
  loadImage(const BagTopic& topic, const BagMessage& message) const
  {
    return topic.type == compressed_type
               ? topics_.read(topic, message, readRosCompressedImage)
               : topics_.read(topic, message, readRosImage);
  }

  /** \brief Nothing if the messages are no images, or of an encoding that is neither of
   * colours nor of depths, as of an infrared camera. */
  std::optional<ImageTopic>
  imagesOf(const BagTopic& topic)
  {
    if (topic.type != image_type && topic.type != compressed_type)
      return {};
    try {
      const RosImage first = loadImage(topic, topic.messages.front());
      ImageTopic images;
      images.topic = &topic;
      images.is_depth = first.isDepth();
      if (images.is_depth && isInfrared(topic.name))
        return {};
      images.is_gray = first.encoding == "mono8" || first.encoding == "8UC1";
      images.frame = first.header.frame;
      const auto setSize = [&](const auto& image) {
        images.width = image.width;
        images.height = image.height;
      };
      if (images.is_depth)
        setSize(depthsOf(first, topic.name));
      else
        setSize(colorsOf(first, topic.name));
      return images;
    }
    catch (const InputFileException& error) {
      unused_.emplace_back(error.what());
      return {};
    }
  }

  /** \brief Drops gray images where there are colours. */
  static void
  preferColors(std::vector<ImageTopic>& colors)
  {
    const auto gray =
        std::stable_partition(colors.begin(),
                              colors.end(),
                              [](const ImageTopic& images) { return !images.is_gray; });
    if (gray != colors.begin())
      colors.erase(gray, colors.end());
  }

  static const ImageTopic&
  mostOf(const std::vector<ImageTopic>& topics)
  {
    return *std::max_element(
        topics.begin(), topics.end(), [](const ImageTopic& a, const ImageTopic& b) {
          return a.topic->messages.size() < b.topic->messages.size();
        });
  }

  /** \brief The depths to take: those that are registered to colours, then the most. */
  const ImageTopic&
  bestDepths(const std::vector<ImageTopic>& depths,
             const std::vector<ImageTopic>& colors) const
  {
    std::vector<ImageTopic const*> registered;
    for (const ImageTopic& depth : depths)
      if (std::any_of(colors.begin(), colors.end(), [&](const ImageTopic& color) {
            return isRegistered(depth, color);
          }))
        registered.push_back(&depth);
    const ImageTopic* best = registered.empty() ? &mostOf(depths) : registered.front();
    for (const ImageTopic* depth : registered)
      if (depth->topic->messages.size() > best->topic->messages.size())
        best = depth;
    return *best;
  }

  std::optional<RosCameraInfo>
  findCamera(const ImageTopic& images) const
  {
    const auto load = [&](const BagTopic& topic) {
      return topics_.read(topic, topic.messages.front(), readRosCameraInfo);
    };
    const auto beside = topics_.all().find(cameraTopicOf(images.topic->name));
    if (beside != topics_.all().end() && beside->second.type == camera_type)
      return load(beside->second);
    for (const BagTopic* topic : topics_.ofType(camera_type))
      if (RosCameraInfo info = load(*topic); info.header.frame == images.frame)
        return info;
    return {};
  }

  RosCameraInfo
  cameraOf(const ImageTopic& images) const
  {
    if (std::optional<RosCameraInfo> camera = findCamera(images))
      return std::move(*camera);
    topics_.fail("has no CameraInfo for " + images.topic->name + ", looked for " +
                 cameraTopicOf(images.topic->name) + "; its topics: " + topics_.list());
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
    depth_unit_ = depthUnit();
    if (!(depth_unit_ > 0 && std::isfinite(depth_unit_)))
      topics_.fail("has depths in a unit that is not above 0");
    if (is_distorted)
      topics_.remark(
          "its images are taken as rectified, though CameraInfo has a distortion");
    pair(every);
  }

  bool
  isRegistered(const ImageTopic& depth, const ImageTopic& color) const
  {
    if (depth.frame != color.frame || depth.width != color.width ||
        depth.height != color.height)
      return false;
    const auto depth_camera = findCamera(depth), color_camera = findCamera(color);
    return !depth_camera || !color_camera ||
           areSame(depth_camera->pinhole, color_camera->pinhole);
  }

  /** \brief T_stream_reference of a stream of RealSense's own recorder. */
  std::optional<Eigen::Isometry3d>
  poseInRealsense(const ImageTopic& images) const
  {
    const std::string stream = realsenseStreamOf(images.topic->name);
    if (!stream.empty())
      for (const BagTopic* topic : topics_.ofType("geometry_msgs/Transform"))
        if (topic->name.rfind(stream + "/tf/", 0) == 0)
          return topics_.read(*topic, topic->messages.front(), readRosBareTransform);
    return {};
  }

  /** \brief Millimetres in a unit of the depths, as RealSense's own recorder states it. */
  double
  depthUnit() const
  {
    constexpr double mm_per_m = 1000;
    if (!realsenseStreamOf(depth_.name).empty())
      for (const BagTopic* topic : topics_.ofType("std_msgs/Float32"))
        if (endsWith(topic->name, "/option/Depth_Units/value") ||
            endsWith(topic->name, "/option/Depth Units/value"))
          return mm_per_m *
                 topics_.read(*topic, topic->messages.front(), readRosNumber);
    return 1;
  }

  /** \brief T_depth_color */
  Eigen::Isometry3d
  poseOfColors(const ImageTopic& depth, const ImageTopic& color) const
  {
    const auto T_depth_reference = poseInRealsense(depth),
               T_color_reference = poseInRealsense(color);
    if (T_depth_reference && T_color_reference)
      return *T_depth_reference * T_color_reference->inverse();
    const double stamp =
        topics_.read(*depth.topic, depth.topic->messages.front(), readRosHeader).stamp;
    const auto T_depth_color =
        topics_.tree().relativePose(depth.frame, color.frame, stamp);
    if (!T_depth_color)
      topics_.fail("has no transform between the frames of depths and colours, " +
                   depth.frame + " and " + color.frame +
                   ", as without tf_static: record it, or depth images that are "
                   "registered to the colours; the frames are: " +
                   topics_.tree().list());
    return *T_depth_color;
  }

  void
  pair(std::size_t every)
  {
    constexpr double max_gap = 0.02; // seconds, as for folders
    const std::vector<double> depth_stamps = topics_.sortByStamps(depth_),
                              color_stamps = topics_.sortByStamps(color_);
    const auto pairs = matchStamps(depth_stamps, color_stamps, max_gap);
    if (pairs.empty())
      topics_.fail("no image of " + color_.name + " was taken within 20 ms of one of " +
                   depth_.name);
    if (pairs.size() < depth_stamps.size())
      topics_.remark(std::to_string(depth_stamps.size() - pairs.size()) +
                     " depth images left out: no colour image was taken near them");
    for (std::size_t i = 0; i < pairs.size(); i += every)
      observations_.push_back({depth_.messages[pairs[i].first],
                               color_.messages[pairs[i].second],
                               depth_stamps[pairs[i].first],
                               Eigen::Isometry3d::Identity()});
  }

  void
  takeClouds(const BagTopic& clouds, std::size_t every)
  {
    depth_ = clouds;
    if (topics_.ofType(cloud_type).size() > 1)
      topics_.remark("took clouds of " + depth_.name);
    const std::vector<double> stamps = topics_.sortByStamps(depth_);
    frame_ = topics_.read(depth_, depth_.messages.front(), readRosHeader).frame;
    if (!isOpticalFrame(frame_))
      T_camera_frame_ = cameraOfBody();
    for (std::size_t i = 0; i < stamps.size(); i += every)
      observations_.push_back(
          {depth_.messages[i], std::nullopt, stamps[i], Eigen::Isometry3d::Identity()});
  }

  void
  takePoses(const BagSettings& settings)
  {
    const bool is_camera = depth_.type != cloud_type || isOpticalFrame(frame_);
    if (!connectSensor(topics_, frame_, is_camera, settings))
      return;
    const Eigen::Isometry3d T_frame_camera =
        cameras_.color ? cameras_.color->T_depth_color : T_camera_frame_.inverse();
    std::vector<BagObservation> posed;
    for (BagObservation& observation : observations_)
      if (const auto T_root_frame =
              topics_.tree().poseInRoot(frame_, observation.stamp)) {
        observation.T_map_camera = *T_root_frame * T_frame_camera;
        posed.push_back(std::move(observation));
      }
    if (posed.empty())
      topics_.fail("has no pose of " + frame_ + " at the times of its observations");
    if (posed.size() < observations_.size())
      topics_.remark(std::to_string(observations_.size() - posed.size()) +
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
      throw InputFileException(topics_.placeOf(topic) + ": has an image of " +
                               sizeText(image) + " pixels, the first one has " +
                               sizeText(size) + " pixels");
  }

  PCLPointCloud2
  imagesAsCloud(const BagObservation& seen) const
  {
    DepthImage depth = depthsOf(loadImage(depth_, seen.depth), topics_.placeOf(depth_));
    if (depth_unit_ != 1)
      for (float& metres : depth.metres)
        metres *= static_cast<float>(depth_unit_);
    const RgbImage color =
        colorsOf(loadImage(color_, *seen.color), topics_.placeOf(color_));
    requireSize(depth, depth_size_, depth_);
    requireSize(color, color_size_, color_);
    return makeRgbdObservation(
               color, measuredPoints(depth, cameras_.depth), depth_size_, cameras_)
        .cloud;
  }

  PCLPointCloud2
  loadCloud(const BagObservation& seen) const
  {
    RosCloud read = topics_.read(depth_, seen.depth, readRosCloud);
    if (!T_camera_frame_.matrix().isIdentity(0))
      turnCloud(T_camera_frame_.linear().cast<float>(), read.cloud);
    return std::move(read.cloud);
  }

  BagTopics topics_;
  std::vector<std::string> unused_; ///< why topics of images are not taken
  BagTopic depth_, color_;          ///< those that are taken; depth: or of clouds
  std::string frame_;               ///< of depths or clouds
  Eigen::Isometry3d T_camera_frame_ = Eigen::Isometry3d::Identity(); ///< of clouds
  RgbdCameras cameras_;
  ImageSize depth_size_, color_size_;
  std::vector<BagObservation> observations_;
  double depth_unit_ = 1; ///< millimetres, of depths that are integers
  bool has_poses_ = false;
};

} // namespace

} // namespace acmap

std::shared_ptr<const ObservationSource>
openBag(const std::string& path, const BagSettings& settings)
{
  if (settings.every == 0)
    acmap::refuseArgument("every", settings.every, "at least 1");
  return std::make_shared<acmap::BagSource>(path, settings);
}

} // namespace pcl
