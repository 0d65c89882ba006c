#include "rig_simulation.h"

#include "../random_streams.h"
#include "gaussian_weights.h"

#include <pcl/core/impl/parallel.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

using Row = Eigen::ArrayXf;
using RowView = Eigen::Map<Row>;
using ConstRowView = Eigen::Map<const Row>;

/** \brief Shading of one image. */
class ShadedShot {
public:
  ShadedShot(const LitView& view,
             const LightPattern* pattern,
             const SimulatedLight& light,
             std::uint64_t stream)
  : view_(view)
  , pattern_(pattern)
  , light_(light)
  , stream_(stream)
  , weights_(gaussianWeights(light.blur))
  , radius_(static_cast<int>(weights_.size() / 2))
  , row_values_(3 * static_cast<std::size_t>(view.width))
  , lit_(row_values_ * static_cast<std::size_t>(view.height))
  {}

  CameraImage
  take()
  {
    CameraImage image;
    image.width = view_.width;
    image.height = view_.height;
    image.channels = 3;
    image.values.resize(lit_.size());
    oneapi::tbb::parallel_for(0, view_.height, [&](int row) { lightRow(row); });
    oneapi::tbb::parallel_for(
        0, view_.height, [&](int row) { exposeRow(row, startOf(row, image.values)); });
    return image;
  }

private:
  template <typename Value>
  Value*
  startOf(int row, std::vector<Value>& values) const
  {
    return values.data() + static_cast<std::size_t>(row) * row_values_;
  }

  /** \brief Computes the light of a row, blurred along the row. */
  void
  lightRow(int row)
  {
    const auto size = static_cast<Eigen::Index>(row_values_);
    const Eigen::Index rim = 3 * radius_;
    Row padded(size + 2 * rim);
    shadeRow(row, padded.data() + rim);
    for (Eigen::Index i = 0; i < rim; ++i) { // border values are repeated outside
      padded[i] = padded[rim + i % 3];
      padded[rim + size + i] = padded[rim + size - 3 + i % 3];
    }
    RowView blurred(startOf(row, lit_), size);
    blurred = weights_[0] * padded.segment(0, size);
    for (Eigen::Index k = 1; k < static_cast<Eigen::Index>(weights_.size()); ++k)
      blurred += weights_[static_cast<std::size_t>(k)] * padded.segment(3 * k, size);
  }

  void
  shadeRow(int row, float* to) const
  {
    const auto start =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(view_.width);
    const auto ambient = static_cast<float>(light_.ambient);
    for (int column = 0; column < view_.width; ++column, to += 3) {
      const std::size_t pixel = start + static_cast<std::size_t>(column);
      const float* const color = &view_.color[3 * pixel];
      const float light = view_.light[pixel];
      std::array<float, 3> thrown{};
      if (pattern_ && light > 0.0f)
        thrown = pattern_->at(view_.u[pixel], view_.v[pixel]);
      for (std::size_t i = 0; i < thrown.size(); ++i)
        to[i] = color[i] * (ambient + light * thrown[i]);
    }
  }

  /** \brief Blurs across the rows, adds the noise and rounds. */
  void
  exposeRow(int row, std::uint8_t* to)
  {
    const auto size = static_cast<Eigen::Index>(row_values_);
    Row value = Row::Zero(size);
    for (int k = -radius_; k <= radius_; ++k) {
      const int from = std::clamp(row + k, 0, view_.height - 1);
      value += weights_[static_cast<std::size_t>(k + radius_)] *
               ConstRowView(startOf(from, lit_), size);
    }
    Row noise(size);
    fillNormal(
        mixedBits(stream_, static_cast<std::uint64_t>(row)), noise.data(), row_values_);
    const auto dark = static_cast<float>(light_.read_noise * light_.read_noise);
    const auto growth = static_cast<float>(light_.shot_noise);
    constexpr float half = 0.5f; // rounding: the conversion below truncates
    value += noise * (dark + growth * value).sqrt() + half;
    value = value.max(0.0f).min(255.0f);
    for (Eigen::Index i = 0; i < size; ++i)
      to[i] = static_cast<std::uint8_t>(static_cast<int>(value[i]));
  }

  const LitView& view_;
  const LightPattern* pattern_;
  const SimulatedLight& light_;
  std::uint64_t stream_;
  std::vector<float> weights_;
  int radius_;
  std::size_t row_values_;
  std::vector<float> lit_; // blurred along the rows
};

} // namespace

CameraImage
shadeShot(const LitView& view,
          const LightPattern* pattern,
          const SimulatedLight& light,
          std::uint64_t stream)
{
  return view.width == 0 ? CameraImage{}
                         : ShadedShot(view, pattern, light, stream).take();
}

} // namespace pcl::acmap
