#include "patch_waves.h"

#include "score_table.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace pcl::acmap {

namespace {

/** The waves along one axis, one per column, from the longest to the shortest. */
using Waves = Eigen::MatrixXd;

/** Half waves, as along rings the ends do not meet. */
Waves
openWaves(int size)
{
  Waves waves(size, size);
  for (int wave = 0; wave < size; ++wave)
    for (int k = 0; k < size; ++k)
      waves(k, wave) = std::cos(EIGEN_PI * wave * (k + 0.5) / size);
  return waves.colwise().normalized();
}

/** A cosine and a sine of each frequency: column k has the frequency (k + 1) / 2. */
Waves
closedWaves(int size)
{
  Waves waves(size, size);
  for (int wave = 0; wave < size; ++wave)
    for (int k = 0; k < size; ++k) {
      const double angle = 2 * EIGEN_PI * ((wave + 1) / 2) * k / size;
      waves(k, wave) = wave % 2 == 0 && wave > 0 ? std::sin(angle) : std::cos(angle);
    }
  return waves.colwise().normalized();
}

constexpr double score_of_one = double{score_length} * score_length;

} // namespace

PatchWaves::PatchWaves(int rings, int sectors)
{
  const Waves of_rings = openWaves(rings), of_sectors = closedWaves(sectors);
  std::vector<int> order(static_cast<std::size_t>(rings * sectors));
  std::iota(order.begin(), order.end(), 0);
  const auto frequency = [&](int wave) {
    return wave / sectors + (wave % sectors + 1) / 2;
  };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return frequency(a) < frequency(b);
  });
  // The first wave is constant, and patches have the mean 0.
  const auto count = std::min(order.size(), size) - 1;
  waves_.resize(static_cast<Eigen::Index>(count), rings * sectors);
  for (std::size_t k = 0; k < count; ++k) {
    const int wave = order[k + 1];
    for (int sample = 0; sample < rings * sectors; ++sample)
      waves_(static_cast<Eigen::Index>(k), sample) =
          static_cast<float>(of_rings(sample / sectors, wave / sectors) *
                             of_sectors(sample % sectors, wave % sectors));
  }
}

void
PatchWaves::numbersOf(const std::int16_t* samples, std::int16_t* numbers) const
{
  using Samples = Eigen::Matrix<std::int16_t, Eigen::Dynamic, 1>;
  const Eigen::VectorXf patch =
      Eigen::Map<const Samples>(samples, waves_.cols()).cast<float>();
  const Eigen::VectorXf amplitudes = waves_ * patch;
  std::fill_n(numbers, size, std::int16_t{0});
  for (Eigen::Index k = 0; k < amplitudes.size(); ++k)
    numbers[k] = static_cast<std::int16_t>(std::lround(amplitudes[k]));
  // Rounded up by more than the error of the squares.
  const double rest = double{patch.squaredNorm()} - double{amplitudes.squaredNorm()};
  numbers[size - 1] = static_cast<std::int16_t>(
      std::ceil(std::sqrt(std::max(rest, 0.0) + 1e-5 * score_of_one)));
}

std::int32_t
PatchWaves::boundOf(std::int32_t score)
{
  constexpr auto rounding = static_cast<std::int32_t>(5e-4 * score_of_one);
  return std::max(score, no_score + rounding) - rounding;
}

} // namespace pcl::acmap
