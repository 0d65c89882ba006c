#pragma once

#include <pcl/core/output_folder.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/rgbd_observation.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Results so far. */
struct RgbdImport {
  pcl::Trajectory trajectory; ///< T_first_camera; identity without poses
  Eigen::Isometry3d T_first_world;
  RgbdImageSizes sizes;    ///< of the images of all frames
  std::size_t empty = 0;   ///< observations without a point
  std::size_t refined = 0; ///< observations whose depth was quantised
  /** \brief Histogram of the numbers in the depth images over all points. */
  std::vector<std::uint64_t> depths = std::vector<std::uint64_t>(65536);
  std::vector<std::string> broken; ///< reasons why frames were left out

  std::uint64_t
  points() const;

  /** \brief Median of the numbers in the depth images over all points. */
  std::uint16_t
  medianDepth() const;
};

/** \brief Converts a frame to an observation in the folder. All of the frame is read
 * and checked before anything is counted or written.
 * \param[in] has_poses the frame has a pose; otherwise all poses are the identity
 * \throws InputFileException when an image or the pose is missing, malformed, or
 * differs in size from the previous ones */
void
importFrame(const RgbdFrame& frame,
            bool has_poses,
            const RgbdCameras& cameras,
            const OutputFolder& folder,
            unsigned threads,
            RgbdImport& import);

} // namespace pcl::acmap
