#pragma once

#include "rgbd_observation.h"
#include "rgbd_sequence.h"

#include <pcl/core/output_folder.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/depth_sensor.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Pixels of an image. */
struct ImageSize {
  std::int32_t width = 0;
  std::int32_t height = 0;
};

/** \brief The cameras of all frames. */
struct RgbdCameras {
  Pinhole depth;
  std::optional<ColorCamera> color; ///< none: the depth camera saw the colours
  DepthMeaning meaning;
  DepthSensor sensor = DepthSensor::Automatic;
};

/** \brief What was done so far. */
struct RgbdImport {
  pcl::Trajectory trajectory; ///< T_first_camera; identity without poses
  Eigen::Isometry3d T_first_world;
  ImageSize color;         ///< of all colour images, and so of the observations
  ImageSize depth;         ///< of all depth images
  std::size_t empty = 0;   ///< observations without a point
  std::size_t refined = 0; ///< observations whose depth was quantised
  /** \brief How many points have the depth of which number in a depth image. */
  std::vector<std::uint64_t> depths = std::vector<std::uint64_t>(65536);
  std::vector<std::string> broken; ///< why frames were left out

  std::uint64_t
  points() const;

  /** \brief Number in a depth image that half of the points do not exceed. */
  std::uint16_t
  medianDepth() const;
};

/** \brief A size as text, with its unit. */
std::string
sizeText(const ImageSize& size);

/** \brief Turns a frame into an observation in the folder. Reads and checks all of it
 * before anything is counted or written.
 * \param[in] has_poses the frame has one; else all are the identity
 * \throws InputFileException when an image or the pose is missing, malformed or of another
 * size than those before */
void
importFrame(const RgbdFrame& frame,
            bool has_poses,
            const RgbdCameras& cameras,
            const OutputFolder& folder,
            unsigned threads,
            RgbdImport& import);

} // namespace pcl::acmap
