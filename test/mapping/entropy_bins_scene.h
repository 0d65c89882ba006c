#pragma once

#include "simd/entropy_bins.h"

#include <pcl/core/random.h>

#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief The kernels for one instruction set. */
struct BinsVariant {
  std::string name;
  const EntropyBins* loops;
};

/** \brief The variants that this processor supports. */
inline std::vector<BinsVariant>
variants()
{
  std::vector<BinsVariant> all{{"base", &entropy_bins_base}};
#ifdef ACMAP_SIMD_AVX2
  if (__builtin_cpu_supports("avx2"))
    all.push_back({"avx2", &entropy_bins_avx2});
#endif
  return all;
}

/** \brief A grid of 40 x 40 bins with nine layers and cells in its centre. */
struct BinsScene {
  static constexpr std::int64_t row = 40, rows = 40, layers = 9;

  std::vector<float> bins = std::vector<float>(row * rows * layers + 4, 0);
  std::vector<std::uint8_t> marks = std::vector<std::uint8_t>(bins.size() / 4, 0);
  std::vector<float> x, z, weight, direction;

  BinsScene(std::uint64_t seed, std::size_t cells)
  {
    Random random(seed);
    for (std::size_t i = 0; i < cells; ++i) {
      x.push_back(static_cast<float>(random.uniform(-8, 8)));
      z.push_back(static_cast<float>(random.uniform(-8, 8)));
      weight.push_back(static_cast<float>(random.uniform(0, 100)));
      direction.push_back(static_cast<float>(random.uniform(-4, 4)));
    }
    x[0] = z[0] = 0.5; // on the border between bins
  }

  CellArrays
  cells() const
  {
    return {x.data(),
            z.data(),
            weight.data(),
            direction.data(),
            static_cast<std::int64_t>(x.size())};
  }

  BinArray
  grid()
  {
    return {bins.data(), row, row * rows, marks.data()};
  }
};

inline constexpr CellMotion motion{0.8, 0.6, 19.5, 20.25, 13.7};

} // namespace pcl::acmap::test
