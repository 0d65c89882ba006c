#include "matching/shot_check.h"

#include <pcl/core/rig_cameras.h>
#include <pcl/stereo/pair_direction.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::acmap {

namespace {

constexpr int longest_row = 480; // px, of the reduced images
constexpr int sampled_rows = 24;
constexpr int column_step = 6;
constexpr int half_width = 5; // of the windows that are compared
constexpr int half_height = 2;
constexpr int window = (2 * half_width + 1) * (2 * half_height + 1);

/** \brief Grey levels of an image, reduced, with its baseline along the rows. */
class ReducedImage {
public:
  ReducedImage(const CameraImage& image, bool is_transposed, int factor)
  : width_((is_transposed ? image.height : image.width) / factor)
  , height_((is_transposed ? image.width : image.height) / factor)
  , greys_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_))
  {
    const auto channels = static_cast<std::size_t>(image.channels);
    for (int row = 0; row < height_ * factor; ++row)
      for (int column = 0; column < width_ * factor; ++column) {
        const auto at = static_cast<std::size_t>(is_transposed ? column : row) *
                            static_cast<std::size_t>(image.width) +
                        static_cast<std::size_t>(is_transposed ? row : column);
        // Green stands in the middle of three channels.
        greys_[index(column / factor, row / factor)] +=
            image.values[at * channels + channels / 2];
      }
  }

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

  /** \brief The window around a pixel less its mean, of length 1; false if it is flat. */
  bool
  windowAt(int column, int row, float* values) const
  {
    float sum = 0;
    float* to = values;
    for (int y = row - half_height; y <= row + half_height; ++y)
      for (int x = column - half_width; x <= column + half_width; ++x)
        sum += * to++ = greys_[index(x, y)];
    float squares = 0;
    for (int i = 0; i < window; ++i) {
      values[i] -= sum / window;
      squares += values[i] * values[i];
    }
    if (!(squares > 1e-3F * sum))
      return false;
    for (int i = 0; i < window; ++i)
      values[i] /= std::sqrt(squares);
    return true;
  }

private:
  std::size_t
  index(int column, int row) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(column);
  }

  int width_;
  int height_;
  std::vector<float> greys_; // sums over the pixels that are joined
};

/** \brief All windows of a row. */
class SampledRow {
public:
  SampledRow(const ReducedImage& image, int row)
  : width_(image.width())
  , values_(static_cast<std::size_t>(width_ * window))
  , has_texture_(static_cast<std::size_t>(width_))
  {
    for (int column = half_width; column < width_ - half_width; ++column)
      has_texture_[static_cast<std::size_t>(column)] =
          image.windowAt(
              column, row, &values_[static_cast<std::size_t>(column * window)])
              ? 1
              : 0;
  }

  bool
  hasTexture(int column) const
  {
    return has_texture_[static_cast<std::size_t>(column)] != 0;
  }

  /** \brief Column of another row that matches best, within a distance; -1 for none. */
  int
  bestIn(const SampledRow& other, int column, int farthest) const
  {
    float best = 0.85F; // least correlation
    int found = -1;
    const int end = std::min(column + farthest, width_ - 1);
    for (int x = std::max(column - farthest, 0); x <= end; ++x) {
      if (!other.hasTexture(x))
        continue;
      const float* const a = &values_[static_cast<std::size_t>(column * window)];
      const float* const b = &other.values_[static_cast<std::size_t>(x * window)];
      float correlation = 0;
      for (int i = 0; i < window; ++i)
        correlation += a[i] * b[i];
      if (correlation > best) {
        best = correlation;
        found = x;
      }
    }
    return found;
  }

private:
  int width_;
  std::vector<float> values_;
  std::vector<char> has_texture_;
};

} // namespace

PairDirection
measureDirection(const TrinocularFrame& frame,
                 const TrinocularRig& rig,
                 RigCamera neighbour)
{
  requireShotOf(rig, frame);
  const bool is_vertical = neighbour == RigCamera::Vertical;
  const CameraImage& image = frame.image(RigCamera::Reference);
  const int factor = (is_vertical ? image.height : image.width) / longest_row + 1;
  const ReducedImage reference(image, is_vertical, factor);
  const ReducedImage other(frame.image(neighbour), is_vertical, factor);
  const bool is_mirrored =
      (is_vertical ? rig.baseline_vertical : rig.baseline_horizontal) < 0.0;
  const double offset = is_vertical ? 0.0 : disparityOffset(rig) / factor;
  const int farthest = reference.width() / 3;
  PairDirection found;
  for (int i = 0; i < sampled_rows; ++i) {
    const int row = (2 * i + 1) * reference.height() / (2 * sampled_rows);
    if (row < half_height || row >= reference.height() - half_height)
      continue;
    const SampledRow from(reference, row);
    const SampledRow to(other, row);
    for (int column = half_width; column < reference.width() - half_width;
         column += column_step) {
      if (!from.hasTexture(column))
        continue;
      const int match = from.bestIn(to, column, farthest);
      if (match < 0 || std::abs(to.bestIn(from, match, farthest) - column) > 1)
        continue;
      const double disparity = (is_mirrored ? match - column : column - match) + offset;
      constexpr double distinct = 1.0; // px
      found.as_stated += disparity >= distinct ? 1 : 0;
      found.opposite += disparity <= -distinct ? 1 : 0;
    }
  }
  return found;
}

} // namespace pcl::acmap
