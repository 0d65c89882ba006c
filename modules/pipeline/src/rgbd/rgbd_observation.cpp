#include "rgbd/image_sizes.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/pipeline/depth_sensor.h>
#include <pcl/pipeline/rgbd_observation.h>

#include <Eigen/Core>

#include <cmath>
#include <limits>

namespace pcl {

namespace {

template <typename Image>
ImageSize
sizeOf(const Image& image)
{
  return {image.width, image.height};
}

/** \param[in] channels numbers per pixel */
template <typename Image, typename Values>
void
requireComplete(const Image& image, const Values& values, std::size_t channels)
{
  const bool is_sound = image.width > 0 && image.height > 0;
  if (!is_sound || values.size() != channels * static_cast<std::size_t>(image.width) *
                                        static_cast<std::size_t>(image.height))
    throw acmap::BadArgument("an image of ",
                             acmap::sizeText(image),
                             " pixels has ",
                             values.size(),
                             " values");
}

/** \brief The points of an image.
 * \param[in] metres depth of a pixel by its index; 0: nothing was measured */
template <typename Image, typename Metres>
std::vector<Eigen::Vector3f>
pointsOf(const Image& image, const Pinhole& camera, const Metres& metres)
{
  const Eigen::Vector3f nothing =
      Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  std::vector<Eigen::Vector3f> points(static_cast<std::size_t>(image.width) *
                                          static_cast<std::size_t>(image.height),
                                      nothing);
  std::size_t index = 0;
  for (std::int32_t row = 0; row < image.height; ++row)
    for (std::int32_t column = 0; column < image.width; ++column, ++index) {
      const double z = metres(index);
      if (z > 0.0)
        points[index] = (z * Eigen::Vector3d((column - camera.cx) / camera.fx,
                                             (row - camera.cy) / camera.fy,
                                             1.0))
                            .cast<float>();
    }
  return points;
}

void
requireCamera(const Pinhole& camera)
{
  if (!(camera.fx > 0 && camera.fy > 0))
    throw acmap::BadArgument("the focal length of a camera is ",
                             camera.fx,
                             ", ",
                             camera.fy,
                             ": it must exceed 0");
}

/** A row of the cloud. */
struct Pixel {
  float x, y, z;
  std::uint32_t rgb;
  float sigma;
};

/** \brief All pixels with their colours, without points. */
std::vector<Pixel>
pixelsWithoutPoint(const RgbImage& color)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<Pixel> pixels;
  pixels.reserve(color.values.size() / 3);
  for (std::size_t i = 0; i + 2 < color.values.size(); i += 3)
    pixels.push_back({nan,
                      nan,
                      nan,
                      std::uint32_t{color.values[i]} << 16 |
                          std::uint32_t{color.values[i + 1]} << 8 | color.values[i + 2],
                      nan});
  return pixels;
}

void
setPoint(Pixel& pixel, const Eigen::Vector3f& point, float sigma)
{
  pixel.x = point.x();
  pixel.y = point.y();
  pixel.z = point.z();
  pixel.sigma = sigma;
}

/** Standard deviation along the ray. */
float
sigmaOf(const Eigen::Vector3d& point)
{
  return static_cast<float>(kinectDepthSigma(point.z()) * point.norm() / point.z());
}

PCLPointCloud2
cloudOf(const std::vector<Pixel>& pixels, std::int32_t width, std::int32_t height)
{
  constexpr auto real = PCLPointField::FLOAT32;
  PCLPointCloud2 cloud = acmap::layoutWith(
      {}, {{"x", real}, {"y", real}, {"z", real}, {"rgb", real}, {"sigma", real}});
  cloud.width = static_cast<uindex_t>(width);
  cloud.height = static_cast<uindex_t>(height);
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.data.resize(acmap::rowsOf(cloud) * cloud.point_step);
  bool is_dense = true;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    is_dense = is_dense && pixels[i].z > 0.0F;
    acmap::setValue(cloud, i, 0, pixels[i]);
  }
  cloud.is_dense = is_dense ? 1 : 0;
  return cloud;
}

/** \param[in] needed 0 x 0 for any size */
void
requireSize(const std::string& path, const ImageSize& size, const ImageSize& needed)
{
  if (needed.width > 0 && (size.width != needed.width || size.height != needed.height))
    throw InputFileException(path + ": has " + acmap::sizeText(size) +
                             " pixels, the images before have " +
                             acmap::sizeText(needed) + " pixels");
}

struct FrameImages {
  RgbImage color; ///< of the depth image's size without a colour camera
  GrayImage16 depth;
  RgbdImageSizes sizes; ///< of the files
};

RgbImage
greyImage(const ImageSize& size)
{
  constexpr std::uint8_t grey = 128;
  const auto pixels =
      static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  return {size.width, size.height, std::vector<std::uint8_t>(3 * pixels, grey)};
}

/** \brief Takes out depths that are not to be trusted. */
void
applyConfidence(const std::string& path, GrayImage16& depth)
{
  const GrayImage16 confidence = loadGrayImage16(path);
  requireSize(path, sizeOf(confidence), sizeOf(depth));
  for (std::size_t i = 0; i < depth.values.size(); ++i)
    if (confidence.values[i] == 0)
      depth.values[i] = 0;
}

/** \brief Colours of another size than the depths, with no camera of their own, are scaled
 * if that is possible. */
void
matchSizes(const RgbdFrame& frame, FrameImages& images)
{
  const ImageSize color = sizeOf(images.color), depth = sizeOf(images.depth);
  if (acmap::areSame(color, depth))
    return;
  if (acmap::isEnlarged(color, depth))
    images.color = scaledImage(images.color, depth);
  else if (const ImageSize turned{color.height, color.width};
           acmap::areSame(turned, depth) || acmap::isEnlarged(turned, depth))
    throw InputFileException(
        frame.depth + ": has " + acmap::sizeText(depth) + " pixels, the colour image " +
        acmap::sizeText(color) +
        ": one of them is turned; ffmpeg -noautorotate -i VIDEO gives the images of a "
        "video as the camera saw them");
  else
    requireSize(frame.depth, depth, color);
}

FrameImages
loadImages(const RgbdFrame& frame,
           const RgbdCameras& cameras,
           const RgbdImageSizes& sizes)
{
  FrameImages images;
  if (!frame.color.empty()) {
    images.color = loadRgbImage(frame.color);
    requireSize(frame.color, sizeOf(images.color), sizes.color);
  }
  images.depth = loadGrayImage16(frame.depth);
  if (frame.color.empty())
    images.color = greyImage(sizeOf(images.depth));
  requireSize(frame.depth, sizeOf(images.depth), sizes.depth);
  images.sizes = {sizeOf(images.color), sizeOf(images.depth)};
  if (!cameras.color)
    matchSizes(frame, images);
  if (!frame.confidence.empty())
    applyConfidence(frame.confidence, images.depth);
  return images;
}

} // namespace

std::vector<Eigen::Vector3f>
measuredPoints(const GrayImage16& depth,
               const Pinhole& camera,
               const DepthMeaning& meaning)
{
  requireComplete(depth, depth.values, 1);
  requireCamera(camera);
  if (!(meaning.scale > 0))
    acmap::refuseArgument("scale of a depth image", meaning.scale, "above 0");
  return pointsOf(
      depth, camera, [&](std::size_t i) { return meaning.metres(depth.values[i]); });
}

std::vector<Eigen::Vector3f>
measuredPoints(const DepthImage& depth, const Pinhole& camera)
{
  requireComplete(depth, depth.metres, 1);
  requireCamera(camera);
  return pointsOf(depth, camera, [&](std::size_t i) { return depth.metres[i]; });
}

PCLPointCloud2
observationCloud(const RgbImage& color, const std::vector<Eigen::Vector3f>& points)
{
  requireComplete(color, color.values, 3);
  if (3 * points.size() != color.values.size())
    throw acmap::BadArgument("there are ",
                             points.size(),
                             " points for an image of ",
                             acmap::sizeText(color),
                             " pixels");
  std::vector<Pixel> pixels = pixelsWithoutPoint(color);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (points[i].z() > 0)
      setPoint(pixels[i], points[i], sigmaOf(points[i].cast<double>()));
  return cloudOf(pixels, color.width, color.height);
}

PCLPointCloud2
registeredCloud(const RgbImage& color,
                const std::vector<Eigen::Vector3f>& points,
                const ColorCamera& color_camera)
{
  requireComplete(color, color.values, 3);
  requireCamera(color_camera.pinhole);
  const Pinhole& seen = color_camera.pinhole;
  const Eigen::Isometry3d T_color_depth = color_camera.T_depth_color.inverse();
  std::vector<Pixel> pixels = pixelsWithoutPoint(color);
  for (const Eigen::Vector3f& measured : points) {
    const Eigen::Vector3d point = T_color_depth * measured.cast<double>();
    if (!(point.z() > 0.0)) // also true for NaN
      continue;
    const Eigen::Vector2d projected = seen.project(point);
    const double column = std::round(projected.x()), row = std::round(projected.y());
    if (!(column >= 0 && column < color.width && row >= 0 && row < color.height))
      continue;
    Pixel& pixel =
        pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(color.width) +
               static_cast<std::size_t>(column)];
    const Eigen::Vector3f place = point.cast<float>();
    if (!(pixel.z <= place.z())) // also true for NaN, if the pixel has no point yet
      setPoint(pixel, place, sigmaOf(measured.cast<double>()));
  }
  return cloudOf(pixels, color.width, color.height);
}

RgbdObservation
makeRgbdObservation(const RgbImage& color,
                    std::vector<Eigen::Vector3f> points,
                    const ImageSize& depth_size,
                    const RgbdCameras& cameras,
                    unsigned threads)
{
  RgbdObservation observation;
  observation.sizes = {sizeOf(color), depth_size};
  PointCloud<PointXYZ> view;
  for (const Eigen::Vector3f& point : points)
    view.push_back(PointXYZ(point.x(), point.y(), point.z()));
  view.width = static_cast<std::uint32_t>(depth_size.width);
  view.height = static_cast<std::uint32_t>(depth_size.height);
  if (refineQuantisedDepth(view, cameras.sensor, threads)) {
    observation.is_refined = true;
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] = view[i].getVector3fMap();
  }
  if (!cameras.color)
    observation.cloud = observationCloud(color, points);
  else if (cameras.color->is_resampled)
    observation.cloud = observationCloud(
        resampledColors(color, points, depth_size, cameras.depth, *cameras.color),
        points);
  else
    observation.cloud = registeredCloud(color, points, *cameras.color);
  return observation;
}

RgbdObservation
loadRgbdObservation(const RgbdFrame& frame,
                    const RgbdCameras& cameras,
                    const RgbdImageSizes& sizes,
                    unsigned threads)
{
  const FrameImages images = loadImages(frame, cameras, sizes);
  RgbdObservation observation =
      makeRgbdObservation(images.color,
                          measuredPoints(images.depth, cameras.depth, cameras.meaning),
                          sizeOf(images.depth),
                          cameras,
                          threads);
  observation.sizes = images.sizes;
  return observation;
}

Eigen::Isometry3d
frameOfObservations(const RgbdCameras& cameras)
{
  return cameras.color && !cameras.color->is_resampled ? cameras.color->T_depth_color
                                                       : Eigen::Isometry3d::Identity();
}

Eigen::Isometry3d
loadPose(const RgbdFrame& frame, const RgbdCameras& cameras)
{
  return loadPose(frame) * frameOfObservations(cameras);
}

} // namespace pcl
