#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/export.h>
#include <pcl/core/image_file.h>
#include <pcl/core/ros_messages.h>
#include <pcl/pipeline/rgbd_cameras.h>
#include <pcl/pipeline/rgbd_sequence.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

/** \brief Standard deviation of a depth measured by a Kinect, along z, metres: axial
 * noise of surfaces that are not slanted, from Nguyen, Izadi, Lovell: Modeling Kinect
 * Sensor Noise for Improved 3D Reconstruction and Tracking, 3DIMPVT 2012.
 * \ingroup pipeline */
inline double
kinectDepthSigma(double z)
{
  return 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4);
}

/** \brief The points of a depth image, one per pixel, metres; NaN if nothing was
 * measured. \ingroup pipeline */
ACMAP_EXPORT std::vector<Eigen::Vector3f>
measuredPoints(const GrayImage16& depth,
               const Pinhole& camera,
               const DepthMeaning& meaning);

/** \brief The same of a depth image in metres. \ingroup pipeline */
ACMAP_EXPORT std::vector<Eigen::Vector3f>
measuredPoints(const DepthImage& depth, const Pinhole& camera);

/** \brief An organized cloud of x y z rgb sigma in the camera's frame, one point per
 * pixel.
 *
 * x y z and sigma are NaN if nothing was measured; rgb is valid at every pixel. sigma
 * is along the ray, which is longer than z for pixels off the centre.
 * \param[in] color one pixel per point \ingroup pipeline */
ACMAP_EXPORT PCLPointCloud2
observationCloud(const RgbImage& color, const std::vector<Eigen::Vector3f>& points);

/** \brief The same in the frame and the pixels of a separate colour camera.
 *
 * A point keeps its measured position, which is up to half a pixel from the centre of
 * its pixel; of several points in a pixel the nearest is used. Pixels without a point
 * have only rgb. sigma is along the ray of the depth camera.
 * \param[in] color of any size
 * \param[in] points of the depth camera. O(n) \ingroup pipeline */
ACMAP_EXPORT PCLPointCloud2
registeredCloud(const RgbImage& color,
                const std::vector<Eigen::Vector3f>& points,
                const ColorCamera& color_camera);

/** \brief The colours of the pixels of a depth camera, from a larger image of a colour camera:
 * each pixel gets the mean of what the colour camera shows there, at the place of its point or,
 * without one, of a point far away; black outside.
 * \param[in] points of the depth camera, one per pixel; O(n) \ingroup pipeline */
ACMAP_EXPORT RgbImage
resampledColors(const RgbImage& color,
                const std::vector<Eigen::Vector3f>& points,
                const ImageSize& depth_size,
                const Pinhole& depth_camera,
                const ColorCamera& color_camera);

/** \brief An image at another size, by the means of its pixels. \ingroup pipeline */
ACMAP_EXPORT RgbImage
scaledImage(const RgbImage& image, const ImageSize& size);

/** \brief Sizes of the images of a frame; 0 x 0 if they are not known.
 * \ingroup pipeline */
struct RgbdImageSizes {
  ImageSize color;
  ImageSize depth;
};

/** \brief A frame of an RGB-D sequence as an observation. \ingroup pipeline */
struct RgbdObservation {
  /** \brief Organized x y z rgb sigma, metres, in the frame and the pixels of the colour
   * camera, or of the depth camera if there is no separate one or it is resampled. */
  PCLPointCloud2 cloud;
  RgbdImageSizes sizes;
  bool is_refined = false; ///< Was the depth quantised?
};

/** \brief Makes an observation of a colour image and the points of a depth image. The steps
 * of quantised depth are removed first (\ref refineQuantisedDepth), in the pixels of the
 * depth camera.
 * \param[in] points of \ref measuredPoints
 * \param[in] depth_size of the depth image
 * \param[in] cameras of the frame; without a colour camera, both images have one size
 * \param[in] threads 0 for all
 * \throws BadArgumentException if sizes do not match
 * \throws UnorganizedPointCloudException as \ref refineQuantisedDepth
 * \ingroup pipeline */
ACMAP_EXPORT RgbdObservation
makeRgbdObservation(const RgbImage& color,
                    std::vector<Eigen::Vector3f> points,
                    const ImageSize& depth_size,
                    const RgbdCameras& cameras,
                    unsigned threads = 0);

/** \brief Reads the images of a frame and converts them to an observation. The steps of
 * quantised depth are removed first (\ref refineQuantisedDepth), in the pixels of the
 * depth camera. Without a colour camera, a larger colour image of the same shape is scaled to
 * the depth image; without a colour image, the colour is grey. Depths whose confidence is 0 are
 * left out.
 * \param[in] sizes of the other frames, which this one must have too; 0 x 0 for any
 * \param[in] threads 0 for all
 * \throws InputFileException when an image is missing, malformed, or of another size; or
 * when there is no colour camera and the images of the frame differ in size
 * \throws UnorganizedPointCloudException as \ref refineQuantisedDepth
 * \ingroup pipeline */
ACMAP_EXPORT RgbdObservation
loadRgbdObservation(const RgbdFrame& frame,
                    const RgbdCameras& cameras,
                    const RgbdImageSizes& sizes = {},
                    unsigned threads = 0);

/** \brief Frame of the observations in that of the depth camera: the colour camera's, or the
 * identity. \ingroup pipeline */
ACMAP_EXPORT Eigen::Isometry3d
frameOfObservations(const RgbdCameras& cameras);

/** \brief Pose of the camera whose frame the observation has, T_world_camera.
 * \throws InputFileException as \ref loadPose(const RgbdFrame&) \ingroup pipeline */
ACMAP_EXPORT Eigen::Isometry3d
loadPose(const RgbdFrame& frame, const RgbdCameras& cameras);

} // namespace pcl
