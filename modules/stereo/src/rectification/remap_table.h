#pragma once

#include "common_view.h"

#include <pcl/core/trinocular_frame.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief For each pixel of a rectified image, where in the raw image it comes from. Whole
 * numbers only, so that every machine gives the same bytes. */
class RemapTable {
public:
  RemapTable(const RigCalibration& calibration,
             const CameraCalibration& camera,
             const CommonView& view);

  /** \param[in] image of the size of the calibration, 1 or 3 channels */
  CameraImage
  apply(const CameraImage& image) const;

private:
  static constexpr int steps = 256; // of a pixel

  /** \brief A pixel and those to its right, below it and below that one, of which at the
   * edges the weight says which counts. Small, as all are read for each image. */
  struct Source {
    std::uint32_t pixel;
    std::uint16_t right; ///< weight of the right ones, 0 to steps
    std::uint16_t below; ///< weight of the lower ones, likewise
  };

  /** \brief Along a row or column. */
  struct Place {
    std::size_t pixel;
    std::size_t rest; ///< steps from the pixel on, 0 to steps
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
