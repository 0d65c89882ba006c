#include "rgbd/layouts.h"
#include "rgbd/recorded_poses.h"

#include <pcl/core/impl/yaml_node.h>

#include <filesystem>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

constexpr const char* images_folder = "results";
constexpr const char* replica_camera_file = "cam_params.json";
constexpr Pinhole replica_camera = {600.0, 600.0, 599.5, 339.5};
constexpr double replica_scale = 6553.5; // 65535 is 10 m

/** \brief The file of the cameras, which stands beside the folders of the scenes; empty if
 * there is none. */
std::string
cameraFileOf(const fs::path& folder)
{
  const fs::path scene = fs::absolute(folder).lexically_normal();
  const fs::path parent =
      (scene.has_filename() ? scene : scene.parent_path()).parent_path();
  fs::path found = findEntry(folder, {replica_camera_file});
  if (found.empty())
    found = findEntry(parent, {replica_camera_file});
  return found.string();
}

/** \brief Takes the camera and the scale of the depths. */
void
takeCamera(const fs::path& folder, bool has_camera, RgbdSequence& sequence)
{
  constexpr double maximum = 1e6;
  sequence.camera = replica_camera;
  sequence.depth_scale = replica_scale;
  const std::string path = cameraFileOf(folder);
  if (path.empty()) {
    sequence.remarks.push_back(
        std::string("no ") + replica_camera_file +
        " tells the camera: took Replica's fx = fy = 600, cx = 599.5, cy = 339.5 and "
        "6553.5 numbers in a metre; --intrinsics and --depth-scale state others");
    return;
  }
  const YamlNode file = loadYaml(path);
  const YamlNode* const inner = file.find("camera");
  const YamlNode& camera = inner ? *inner : file;
  sequence.depth_scale = camera.at("scale").number(1e-6, maximum);
  if (has_camera)
    return;
  sequence.camera = {camera.at("fx").number(1e-6, maximum),
                     camera.at("fy").number(1e-6, maximum),
                     camera.at("cx").number(-maximum, maximum),
                     camera.at("cy").number(-maximum, maximum)};
  const YamlNode* const width = camera.find("w");
  const YamlNode* const height = camera.find("h");
  if (width && height)
    sequence.camera_size = {static_cast<std::int32_t>(width->number(1, maximum)),
                            static_cast<std::int32_t>(height->number(1, maximum))};
}

} // namespace

bool
isReplicaSequence(const std::string& folder)
{
  std::error_code error;
  const fs::path images = findEntry(folder, {images_folder});
  if (!fs::is_directory(images, error))
    return false;
  for (fs::directory_iterator entry(images, error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().filename().string().rfind("depth", 0) == 0)
      return true;
  return false;
}

RgbdSequence
openReplicaSequence(const std::string& folder, const RgbdSequenceSettings& settings)
{
  const fs::path images = findEntry(folder, {images_folder});
  RgbdSequence sequence;
  sequence.layout = "Replica";
  sequence.is_registered = true;
  NamedFrames named = joinedImages(depthImagesIn(images, "depth"),
                                   colorImagesIn(images, "frame"),
                                   settings.max_stamp_gap,
                                   images.string());
  takeCamera(folder, settings.has_camera, sequence);
  if (settings.has_poses)
    takePosesOfFolder(folder, settings.max_stamp_gap, named, sequence);
  takeFrames(std::move(named), sequence);
  return sequence;
}

} // namespace pcl::acmap
