#include "frame_import.h"

#include <pcl/core/cloud_fields.h>
#include <pcl/core/exceptions.h>
#include <pcl/pipeline/observation_files.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace pcl::acmap {

namespace {

template <typename Image>
ImageSize
sizeOf(const Image& image)
{
  return {image.width, image.height};
}

/** \param[in] needed 0 x 0 for any size */
void
requireSize(const std::string& path, const ImageSize& size, const ImageSize& needed)
{
  if (needed.width > 0 && (size.width != needed.width || size.height != needed.height))
    throw InputFileException(path + ": has " + sizeText(size) +
                             ", the images before have " + sizeText(needed));
}

struct FrameImages {
  RgbImage color;
  GrayImage16 depth;
};

FrameImages
loadImages(const RgbdFrame& frame, const RgbdCameras& cameras, const RgbdImport& import)
{
  FrameImages images{loadRgbImage(frame.color), loadGrayImage16(frame.depth)};
  requireSize(frame.color, sizeOf(images.color), import.color);
  requireSize(frame.depth,
              sizeOf(images.depth),
              cameras.color ? import.depth : sizeOf(images.color));
  return images;
}

/** Quantisation steps are removed in the pixels of the depth camera. */
PCLPointCloud2
cloudOf(const FrameImages& images,
        const RgbdCameras& cameras,
        unsigned threads,
        RgbdImport& import)
{
  std::vector<Eigen::Vector3f> points =
      measuredPoints(images.depth, cameras.depth, cameras.meaning);
  PointCloud<PointXYZ> view;
  for (const Eigen::Vector3f& point : points)
    view.push_back(PointXYZ(point.x(), point.y(), point.z()));
  view.width = static_cast<std::uint32_t>(images.depth.width);
  view.height = static_cast<std::uint32_t>(images.depth.height);
  if (refineQuantisedDepth(view, cameras.sensor, threads)) {
    ++import.refined;
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] = view[i].getVector3fMap();
  }
  return cameras.color ? registeredCloud(images.color, points, *cameras.color)
                       : observationCloud(images.color, points);
}

/** \brief Pose of the camera whose pixels the observation has. */
Eigen::Isometry3d
poseInWorld(const RgbdFrame& frame, const RgbdCameras& cameras)
{
  const Eigen::Isometry3d T_world_depth = poseOf(frame);
  return cameras.color ? T_world_depth * cameras.color->T_depth_color : T_world_depth;
}

/** \brief Pose in the map, which is the frame of the first written camera. */
Eigen::Isometry3d
poseInMap(const Eigen::Isometry3d& T_world_camera, RgbdImport& import)
{
  if (import.trajectory.poses.empty()) {
    import.T_first_world = T_world_camera.inverse();
    return Eigen::Isometry3d::Identity();
  }
  return import.T_first_world * T_world_camera;
}

void
countDepths(const PCLPointCloud2& cloud, double depth_scale, RgbdImport& import)
{
  const std::size_t offset = findField(cloud, "z")->offset;
  const auto most = static_cast<double>(import.depths.size() - 1);
  bool is_empty = true;
  for (std::size_t i = 0; i < rowsOf(cloud); ++i) {
    float z = 0;
    std::memcpy(&z, &cloud.data[i * cloud.point_step + offset], sizeof z);
    if (!(z > 0.0F))
      continue;
    const double number = std::min(std::round(z * depth_scale), most);
    ++import.depths[static_cast<std::size_t>(number)];
    is_empty = false;
  }
  if (is_empty)
    ++import.empty;
}

} // namespace

std::uint64_t
RgbdImport::points() const
{
  return std::accumulate(depths.begin(), depths.end(), std::uint64_t{0});
}

std::uint16_t
RgbdImport::medianDepth() const
{
  std::uint64_t left = (points() + 1) / 2;
  std::size_t number = 0;
  while (number + 1 < depths.size() && depths[number] < left)
    left -= depths[number++];
  return static_cast<std::uint16_t>(number);
}

std::string
sizeText(const ImageSize& size)
{
  return std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels";
}

void
importFrame(const RgbdFrame& frame,
            bool has_poses,
            const RgbdCameras& cameras,
            const OutputFolder& folder,
            unsigned threads,
            RgbdImport& import)
{
  const Eigen::Isometry3d T_world_camera =
      has_poses ? poseInWorld(frame, cameras) : Eigen::Isometry3d::Identity();
  const FrameImages images = loadImages(frame, cameras, import);
  const Eigen::Isometry3d T_map_camera = poseInMap(T_world_camera, import);
  const PCLPointCloud2 cloud = cloudOf(images, cameras, threads, import);
  saveObservation(folder.path(observationName(import.trajectory.poses.size())),
                  cloud,
                  T_map_camera);
  countDepths(cloud, cameras.meaning.scale, import);
  import.color = sizeOf(images.color);
  import.depth = sizeOf(images.depth);
  import.trajectory.stamps.push_back(frame.stamp);
  import.trajectory.poses.push_back(T_map_camera);
}

} // namespace pcl::acmap
