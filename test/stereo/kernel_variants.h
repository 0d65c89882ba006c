#pragma once

#include "simd/pair_kernels.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <vector>

namespace pcl::acmap::test {

/** \brief Random inputs, including values that variants of a kernel could treat
 * differently. */
class Draw {
public:
  explicit Draw(bool has_edges)
  : has_edges_(has_edges)
  {}

  std::vector<float>
  floats(std::size_t size)
  {
    constexpr float maximum = std::numeric_limits<float>::max();
    static const float edges[] = {0.0F,
                                  -0.0F,
                                  std::numeric_limits<float>::denorm_min(),
                                  -3e-39F,
                                  maximum,
                                  -maximum,
                                  std::numeric_limits<float>::infinity(),
                                  std::numeric_limits<float>::quiet_NaN()};
    std::vector<float> all(size);
    for (float& one : all)
      one = has_edges_ && random_.bits() % 16 == 0
                ? edges[random_.bits() % std::size(edges)]
                : static_cast<float>(random_.uniform(-1, 1));
    return all;
  }

  template <typename Integer>
  std::vector<Integer>
  integers(std::size_t size, double minimum, double maximum)
  {
    std::vector<Integer> all(size);
    for (Integer& one : all)
      one = static_cast<Integer>(random_.uniform(minimum, maximum));
    return all;
  }

  std::vector<std::uint64_t>
  words(std::size_t size)
  {
    std::vector<std::uint64_t> all(size);
    for (std::uint64_t& one : all)
      one = random_.bits() % 16 == 0 ? ~std::uint64_t{0} : random_.bits();
    return all;
  }

private:
  Random random_{9};
  bool has_edges_;
};

/** \brief Compares with any NaN, as the standard does not define which NaN a sum returns. */
inline bool
areSame(const std::vector<float>& a, const std::vector<float>& b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::memcmp(&a[i], &b[i], sizeof a[i]) != 0 &&
        !(std::isnan(a[i]) && std::isnan(b[i])))
      return false;
  return a.size() == b.size();
}

/** \brief Widths that are not multiples of the vector size, strides of one and several
 * blocks. */
class KernelVariants : public testing::Test {
protected:
  void
  SetUp() override
  {
    if (!__builtin_cpu_supports("avx2"))
      GTEST_SKIP() << "this processor has no AVX2";
  }

  /** \param[in] check function of (width, stride, shots), and the source of random
   * inputs */
  template <typename Check>
  static void
  forSizes(const Check& check)
  {
    for (const bool has_edges : {false, true})
      for (std::size_t width = 0; width <= 40; ++width)
        for (const std::size_t stride : {16U, 48U, 80U})
          for (const std::size_t shots : {0U, 1U, 7U}) {
            Draw draw(has_edges);
            check(draw, width, stride, shots);
          }
  }
};

template <typename Value>
ShotRows<Value>
rowsOf(const std::vector<Value>& values, std::size_t plane, std::size_t shots)
{
  return {values.data(), static_cast<std::int64_t>(plane), static_cast<int>(shots)};
}

} // namespace pcl::acmap::test
