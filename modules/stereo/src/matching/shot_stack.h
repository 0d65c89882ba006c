#pragma once

#include "../simd/pair_kernels.h"

#include <pcl/core/trinocular_frame.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief How a camera's image is laid so that its pair is always searched the same way: a
 * pixel of the reference at column x lies in the neighbour's row at x + disparity. */
struct PairLayout {
  bool transposed = false; ///< the neighbour stands above or below
  bool mirrored = false;   ///< it stands to the right, or below
};

/** \brief Of a Gaussian, from the middle outwards; on both sides they add up to 1024. Whole
 * numbers, which a float holds exactly and multiplies faster. */
struct BlurWeights {
  explicit BlurWeights(double sigma);

  int
  apply(float middle, float near, float far) const
  {
    return static_cast<int>(
        (weights[0] * middle + weights[1] * near + weights[2] * far + 512.0F) *
        (1.0F / 1024.0F));
  }

  std::array<float, 3> weights;
};

/** \brief Grey levels of one camera in several shots, blurred, as whole numbers, with a
 * border that repeats the outermost ones. */
class ShotStack {
public:
  static constexpr int border = 4; ///< pixels on each side, more behind a row
  static constexpr int unit = 16;  ///< in a grey level

  /** \brief Replaces what was read before, in its memory.
   * \param[in] images of one size, whole
   * \param[in] blur px, one standard deviation
   * \param[in] behind pixels to be read behind the end of a row
   * Runs in all threads of the caller's arena. */
  void
  read(const std::vector<const CameraImage*>& images,
       const PairLayout& layout,
       double blur,
       int behind);

  /** \brief Takes the mean over the shots off each pixel; there are two shots at least. */
  void
  takeOffMean();

  int
  width() const
  {
    return width_;
  }

  int
  height() const
  {
    return height_;
  }

  int
  shots() const
  {
    return shots_;
  }

  /** \brief From \a column of \a row on, each up to \ref border beside the image. */
  ShotRows<std::int16_t>
  rows(int row, int column = 0) const
  {
    return {values_.data() + offset(row, column), plane_, shots_};
  }

private:
  std::int64_t
  offset(int row, int column) const
  {
    return static_cast<std::int64_t>(row + border) * stride_ + column + border;
  }

  void
  fill(const CameraImage& image,
       const PairLayout& layout,
       const BlurWeights& weights,
       std::int16_t* plane);

  int width_ = 0;
  int height_ = 0;
  int shots_ = 0;
  int stride_ = 0;
  std::int64_t plane_ = 0;
  std::vector<std::int16_t> values_;
};

} // namespace pcl::acmap
