#pragma once

#include "chain/pinhole.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief A piece of surface: the points of a block of pixels, and the plane through
 * those of the blocks around it. */
struct SurfaceBlock {
  Eigen::Vector3d point;  ///< metres, mean of the block's points
  Eigen::Vector3d center; ///< metres, on the plane
  Eigen::Vector3d normal; ///< unit, towards the camera; zero where there is no plane
  /** m^2, of either along the normal: neighbours err alike (they were matched by
   * overlapping windows), so the mean of a block is hardly better than its points. */
  double variance = 0;

  bool
  isPlane() const
  {
    return !normal.isZero();
  }
};

/** \brief A cloud brought to its noise scale in the image: one piece of surface a
 * block. */
struct SurfaceBlocks {
  static constexpr int size = 8; ///< pixels
  int width = 0, height = 0;     ///< blocks
  std::vector<SurfaceBlock> blocks;

  /** \brief The block that shows a pixel, nullptr outside of the image. */
  const SurfaceBlock*
  at(const Eigen::Vector2d& pixel) const
  {
    const double column = (pixel.x() + 0.5) / size;
    const double row = (pixel.y() + 0.5) / size;
    if (!(column >= 0 && row >= 0 && column < width && row < height))
      return nullptr;
    return &blocks[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(column)];
  }
};

/** \param[in] view with sigmas */
SurfaceBlocks
surfaceBlocks(const CameraView& view);

/** \brief Standard deviations along the rays as the surfaces themselves show: grown
 * with the square of the depth, so that planes look as rough as they are. */
std::vector<float>
estimatedSigmas(const CameraView& view);

} // namespace pcl::acmap
