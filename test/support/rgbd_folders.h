#pragma once

#include "temporary_folder.h"

#include <pcl/core/image_file.h>

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Default size of all images of the generated folders. */
constexpr std::int32_t small_width = 8;
constexpr std::int32_t small_height = 6;

/** \brief An image whose colours encode pixel and frame. */
RgbImage
tellingColors(int frame,
              std::int32_t width = small_width,
              std::int32_t height = small_height);

/** \brief Depths that encode pixel and frame, 1000 and more; the first pixel is 0, the
 * second 65535. */
std::vector<std::uint16_t>
tellingDepths(int frame);

/** \brief Pose of the camera of a generated folder, T_world_camera; the first one is
 * neither at the origin nor unrotated. */
Eigen::Isometry3d
posedAt(int frame);

/** \brief A matrix as text, with all its digits. */
std::string
matrixText(const Eigen::MatrixXd& matrix);

/** \brief A row `stamp tx ty tz qx qy qz qw`. */
std::string
poseRow(double stamp, const Eigen::Isometry3d& pose);

/** \brief Writes frame-000000.color.png, .depth.png and .pose.txt, frames ten apart,
 * and camera-intrinsics.txt: fx 10, fy 20, cx 3.5, cy 2.5. */
void
writeSevenScenes(const TemporaryFolder& folder, int frames);

/** \brief Writes rgb.txt, depth.txt, groundtruth.txt and their images. Depth is taken
 * every 0.1 s, colour 4 ms later, a pose 10 ms before and 10 ms after each depth
 * image. */
void
writeTum(const TemporaryFolder& folder, int frames);

/** \brief Bytes as a string, for writing. */
std::string
textOfBytes(const std::vector<std::uint8_t>& bytes);

} // namespace pcl::acmap::test
