#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/pinhole.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace pcl::acmap::bench {

/** \brief A view of a compact map: for each pixel the colour of the first chart that
 * its ray intersects. */
struct MapView {
  std::vector<std::uint8_t> rgb;      ///< 3 per pixel, in row-major order from the top
  std::vector<std::uint8_t> is_known; ///< one per pixel: a texel with colour was hit
  std::vector<float> depth;           ///< one per pixel, metres along the camera's axis
};

/** \brief A camera and the size of its images in pixels. */
struct ViewCamera {
  Pinhole pinhole;
  int width = 0, height = 0;
};

/** \brief Renders a map; texels are interpolated bilinearly. */
MapView
castMap(const CompactMap& map,
        const ViewCamera& camera,
        const Eigen::Isometry3d& T_map_camera);

/** \brief Structural similarity (SSIM) of the brightness of two images, mean over windows of 8 x
 * 8 pixels, 4 apart; windows with unknown pixels are ignored.
 * \param[in] a, b three values per pixel
 * \param[in] is_known one value per pixel
 * \return NaN if there is no such window */
double
structuralSimilarity(const std::vector<std::uint8_t>& a,
                     const std::vector<std::uint8_t>& b,
                     const std::vector<std::uint8_t>& is_known,
                     std::size_t width);

} // namespace pcl::acmap::bench
