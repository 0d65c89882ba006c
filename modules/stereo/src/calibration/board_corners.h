#pragma once

#include <pcl/stereo/rig_calibrator_types.h>

#include <Eigen/Core>

namespace pcl::acmap {

/** \brief The corners of a board in an image, or the reason why there are none. */
struct BoardCorners {
  std::vector<Eigen::Vector2f> corners; ///< rows * columns, row by row, px
  std::string reason;                   ///< empty if the board is good
};

/** \brief Finds the board. The first corner is the same physical corner in each image:
 * the order is clockwise on the board and starts at a dark square. */
BoardCorners
findBoard(const CameraImage& image, const CalibrationBoard& board);

} // namespace pcl::acmap
