#pragma once

#include <pcl/core/build_config.h>

#include <cmath>
#include <cstdint>

namespace pcl::acmap {

/** \brief Seeded random numbers that are the same on every platform (the distributions
 * of the standard library are not). The generator is SplitMix64; use a separate seed
 * for each task. */
class Random {
public:
  explicit Random(std::uint64_t seed)
  : state_(seed)
  {}

  std::uint64_t
  bits()
  {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /** \brief Uniform in [least, most). */
  double
  uniform(double minimum = 0.0, double maximum = 1.0)
  {
    return minimum +
           (maximum - minimum) * (static_cast<double>(bits() >> 11) * 0x1.0p-53);
  }

  /** \brief Normal with mean 0 and standard deviation 1 (Marsaglia's polar method). */
  double
  normal()
  {
    for (;;) {
      const double u = uniform(-1.0, 1.0);
      const double v = uniform(-1.0, 1.0);
      const double s = u * u + v * v;
      if (s > 0.0 && s < 1.0)
        return u * std::sqrt(-2.0 * std::log(s) / s);
    }
  }

private:
  std::uint64_t state_;
};

} // namespace pcl::acmap
