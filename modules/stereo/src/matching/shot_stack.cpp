#include "shot_stack.h"

#include "../simd/image_kernels.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

constexpr int blur_reach = 2;

/** Grey levels of an image, in 16ths. */
std::vector<std::int16_t>
greyOf(const CameraImage& image)
{
  const int pixels = image.width * image.height;
  std::vector<std::int16_t> grey(static_cast<std::size_t>(pixels));
  if (image.channels == 1)
    std::transform(
        image.values.begin(), image.values.end(), grey.begin(), [](std::uint8_t value) {
          return static_cast<std::int16_t>(ShotStack::unit * value);
        });
  else
    imageKernels().toGrey(image.values.data(), pixels, grey.data());
  return grey;
}

/** Rows of an image that is transposed or mirrored. */
class LevelRows {
public:
  LevelRows(const CameraImage& image, const PairLayout& layout)
  : grey_(greyOf(image))
  , layout_(layout)
  , image_width_(image.width)
  , width_(layout.transposed ? image.height : image.width)
  {}

  void
  read(int y, float* levels) const
  {
    if (layout_.transposed)
      for (int x = 0; x < width_; ++x)
        levels[x] = at(x, y);
    else
      imageKernels().toFloats(&grey_[index(0, y)], width_, levels);
    if (layout_.mirrored)
      std::reverse(levels, levels + width_);
  }

private:
  std::size_t
  index(int column, int row) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(image_width_) +
           static_cast<std::size_t>(column);
  }

  float
  at(int x, int y) const
  {
    return grey_[index(y, x)];
  }

  std::vector<std::int16_t> grey_;
  PairLayout layout_;
  int image_width_, width_;
};

/** Repeats the first and the last value outside the range. */
template <typename Value>
void
repeatEnds(Value* values, int size, int before, int behind)
{
  std::fill(values - before, values, values[0]);
  std::fill(values + size, values + size + behind, values[size - 1]);
}

} // namespace

BlurWeights::BlurWeights(double sigma)
{
  const double near = std::exp(-0.5 / (sigma * sigma));
  const double far = std::exp(-2.0 / (sigma * sigma));
  const double unit = 1024.0 / (1.0 + 2.0 * (near + far));
  weights[1] = static_cast<float>(std::lround(unit * near));
  weights[2] = static_cast<float>(std::lround(unit * far));
  weights[0] = 1024.0F - 2.0F * (weights[1] + weights[2]);
}

void
ShotStack::read(const std::vector<const CameraImage*>& images,
                const PairLayout& layout,
                double blur,
                int behind)
{
  width_ = layout.transposed ? images.front()->height : images.front()->width;
  height_ = layout.transposed ? images.front()->width : images.front()->height;
  shots_ = static_cast<int>(images.size());
  stride_ = width_ + 2 * border + behind;
  plane_ = static_cast<std::int64_t>(height_ + 2 * border) * stride_;
  values_.resize(static_cast<std::size_t>(plane_ * shots_));
  const BlurWeights weights(blur);
  oneapi::tbb::parallel_for(std::size_t{0}, images.size(), [&](std::size_t k) {
    fill(*images[k],
         layout,
         weights,
         values_.data() + static_cast<std::int64_t>(k) * plane_);
  });
}

void
ShotStack::fill(const CameraImage& image,
                const PairLayout& layout,
                const BlurWeights& weights,
                std::int16_t* plane)
{
  const ImageKernels& kernels = imageKernels();
  const LevelRows level_rows(image, layout);
  constexpr int kept = 2 * blur_reach + 1;
  const auto width = static_cast<std::size_t>(width_);
  std::vector<float> across(kept * width), row(width + 2 * blur_reach);
  float* const levels = row.data() + blur_reach;
  const auto rowOf = [&](int y) {
    const int there = std::clamp(y, 0, height_ - 1);
    return across.data() + static_cast<std::ptrdiff_t>(there % kept) * width_;
  };
  int read = 0;
  const auto readUpTo = [&](int last) {
    for (; read <= std::min(last, height_ - 1); ++read) {
      level_rows.read(read, levels);
      repeatEnds(levels, width_, blur_reach, blur_reach);
      kernels.blurAlong(levels, width_, weights.weights.data(), rowOf(read));
    }
  };
  for (int y = -border; y < height_ + border; ++y) {
    const int middle = std::clamp(y, 0, height_ - 1);
    readUpTo(middle + blur_reach);
    const float* const rows[] = {rowOf(middle - 2),
                                 rowOf(middle - 1),
                                 rowOf(middle),
                                 rowOf(middle + 1),
                                 rowOf(middle + 2)};
    std::int16_t* const out = plane + offset(y, 0);
    kernels.blurAcross(rows, width_, weights.weights.data(), out);
    repeatEnds(out, width_, border, stride_ - border - width_);
  }
}

void
ShotStack::takeOffMean()
{
  const float share = 1.0F / static_cast<float>(shots_);
  oneapi::tbb::parallel_for(0, height_ + 2 * border, [&](int row) {
    std::int16_t* const begin =
        values_.data() + static_cast<std::int64_t>(row) * stride_;
    std::vector<float> sums(static_cast<std::size_t>(stride_));
    for (int k = 0; k < shots_; ++k)
      for (int x = 0; x < stride_; ++x)
        sums[static_cast<std::size_t>(x)] += begin[k * plane_ + x];
    std::vector<std::int16_t> means(sums.size());
    for (std::size_t x = 0; x < sums.size(); ++x)
      means[x] = static_cast<std::int16_t>(share * sums[x] + 0.5F);
    for (int k = 0; k < shots_; ++k)
      for (int x = 0; x < stride_; ++x)
        begin[k * plane_ + x] = static_cast<std::int16_t>(
            begin[k * plane_ + x] - means[static_cast<std::size_t>(x)]);
  });
}

} // namespace pcl::acmap
