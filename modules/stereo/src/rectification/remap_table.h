#pragma once

#include "common_view.h"

#include <pcl/core/trinocular_frame.h>

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

  /** \param[in] image of the size of the calibration */
  CameraImage
  apply(const CameraImage& image) const;

private:
  static constexpr int steps = 256; // of a pixel

  /** \brief Weights are of the right and of the lower neighbour, in steps. */
  struct Source {
    std::int32_t column;
    std::int32_t row;
    std::int32_t right;
    std::int32_t below;
  };

  std::int32_t width_;
  std::int32_t height_;
  std::vector<Source> sources_;
};

} // namespace pcl::acmap
