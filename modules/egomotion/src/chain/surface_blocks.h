#pragma once

#include <pcl/egomotion/impl/egomotion_kernel.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief A surface block: the points of a block of pixels, and the plane through those
 * of the surrounding blocks. */
struct SurfaceBlock {
  Eigen::Vector3d point;  ///< mean of the block's points, metres
  Eigen::Vector3d center; ///< point on the plane, metres
  Eigen::Vector3d normal; ///< unit, towards the camera; zero if there is no plane
  /** Variance of both along the normal, m^2. Errors of neighbours are correlated (they
   * were matched by overlapping windows), so the mean of a block is hardly better than
   * its points. */
  double variance = 0;

  bool
  isPlane() const
  {
    return !normal.isZero();
  }
};

/** \brief A cloud at its noise scale in the image: one surface block per block of
 * pixels. */
struct SurfaceBlocks {
  static constexpr int size = 8; ///< pixels
  int width = 0, height = 0;     ///< blocks
  std::vector<SurfaceBlock> blocks;

  /** \brief The block that contains a pixel; nullptr outside of the image. */
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

/** \param[in] view must have sigmas */
SurfaceBlocks
surfaceBlocks(const CameraView& view);

/** \brief Standard deviations along the rays, estimated from the roughness of the
 * planes in the view; they grow with the square of the depth. */
std::vector<float>
estimatedSigmas(const CameraView& view);

} // namespace pcl::acmap
