#pragma once

#include "../simd/pair_kernels.h"

#include <pcl/core/trinocular_frame.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief How an image is transposed and mirrored so that every pair is searched in the
 * same direction: a pixel of the reference at column x corresponds to the column x +
 * disparity in the same row of the neighbour. */
struct PairLayout {
  bool transposed = false; ///< the neighbour is above or below
  bool mirrored = false;   ///< the neighbour is to the right, or below
};

/** \brief Weights of a Gaussian, from the middle outwards; the sum over both sides is
 * 1024. They are integers, which a float represents exactly and multiplies faster. */
struct BlurWeights {
  explicit BlurWeights(double sigma);

  std::array<float, 3> weights;
};

/** \brief Blurred grey levels of one camera in several shots, as integers, with a
 * border that repeats the outermost pixels. */
class ShotStack {
public:
  static constexpr int border = 4; ///< pixels on each side; more are behind a row
  static constexpr int unit = 16;  ///< per grey level

  /** \brief Replaces the images that were read before and reuses their memory. Runs in
   * all threads of the caller's arena.
   * \param[in] images complete and of one size
   * \param[in] blur standard deviation, px
   * \param[in] behind number of pixels behind the end of a row that can be read */
  void
  read(const std::vector<const CameraImage*>& images,
       const PairLayout& layout,
       double blur,
       int behind);

  /** \brief Subtracts the mean over the shots from each pixel; requires at least two
   * shots. */
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

  /** \brief Values from \a column of \a row on; both may be up to \ref border outside
   * the image. */
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
