#pragma once

#include "common_view.h"

#include <pcl/core/trinocular_frame.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief For each pixel of a rectified image, its position in the raw image. Uses only
 * integers, so that every machine gives the same bytes. */
class RemapTable {
public:
  RemapTable(const RigCalibration& calibration,
             const CameraCalibration& camera,
             const CommonView& view);

  /** \param[in] image of the size of the calibration, 1 or 3 channels */
  CameraImage
  apply(const CameraImage& image) const;

private:
  static constexpr int steps = 256; // per pixel

  /** \brief Interpolates between a pixel and its neighbours to the right, below, and
   * below right; at the border the weights select the pixels. The structure is small,
   * because all of them are read for each image. */
  struct Source {
    std::uint32_t pixel;
    std::uint16_t right; ///< weight of the neighbours to the right, 0 to steps
    std::uint16_t below; ///< weight of the neighbours below, 0 to steps
  };

  /** \brief Position along a row or column. */
  struct Place {
    std::size_t pixel;
    std::size_t rest; ///< offset from the pixel in steps, 0 to steps
  };

  static Place
  placeOf(double value, std::size_t size);

  template <std::size_t channels>
  void
  fill(const std::uint8_t* from,
       std::size_t begin,
       std::size_t end,
       std::uint8_t* to) const;

  std::size_t width_;
  std::size_t height_;
  std::vector<Source> sources_;
};

} // namespace pcl::acmap
