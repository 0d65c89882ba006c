#pragma once

#include "temporary_folder.h"

#include <pcl/core/image_file.h>

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Size of all images of the made folders, unless a test wants another. */
constexpr std::int32_t small_width = 8;
constexpr std::int32_t small_height = 6;

/** \brief A colour that tells pixel and frame. */
RgbImage
tellingColors(int frame,
              std::int32_t width = small_width,
              std::int32_t height = small_height);

/** \brief Depths that tell pixel and frame, 1000 and up; the first pixel holds 0, the
 * second 65535. */
std::vector<std::uint16_t>
tellingDepths(int frame);

/** \brief Where the camera of a made folder is, T_world_camera; the first one is neither
 * at the origin nor straight. */
Eigen::Isometry3d
posedAt(int frame);

/** \brief A matrix as text, with all its digits. */
std::string
matrixText(const Eigen::MatrixXd& matrix);

/** \brief A row `stamp tx ty tz qx qy qz qw`. */
std::string
poseRow(double stamp, const Eigen::Isometry3d& pose);

/** \brief Writes frame-000000.color.png, .depth.png and .pose.txt, frames ten apart, and
 * camera-intrinsics.txt: fx 10, fy 20, cx 3.5, cy 2.5. */
void
writeSevenScenes(const TemporaryFolder& folder, int frames);

/** \brief Writes rgb.txt, depth.txt, groundtruth.txt and the images they name. Depth is
 * taken each 0.1 s, colour 4 ms later, a pose 10 ms before and 10 ms after each depth. */
void
writeTum(const TemporaryFolder& folder, int frames);

/** \brief Bytes as a string, to be written. */
std::string
textOfBytes(const std::vector<std::uint8_t>& bytes);

} // namespace pcl::acmap::test
