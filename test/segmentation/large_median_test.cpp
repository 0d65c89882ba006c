#include "large_median.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

void
compareWithMedian(const std::vector<double>& values)
{
  std::vector<double> valid;
  for (const double value : values)
    if (value >= 0)
      valid.push_back(value);
  const LargeMedian median =
      largeMedianOf(values.size(), [&](std::size_t i) { return values[i]; });
  EXPECT_EQ(median.count, valid.size());
  EXPECT_EQ(median.value, medianOf(valid));
}

TEST(LargeMedian, isTheMedianOfTheSortedValues)
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  compareWithMedian({});
  compareWithMedian({none, none});
  compareWithMedian({3});
  compareWithMedian({0, 0, 0, 5});
  compareWithMedian({0, std::numeric_limits<double>::denorm_min(), 1e-300, 1e300});
  Random random(4);
  for (const std::size_t size : {10, 1000, 100000}) {
    std::vector<double> values;
    for (std::size_t i = 0; i < size; ++i)
      values.push_back(i % 7 == 0 ? none : std::exp(20 * random.normal()));
    compareWithMedian(values);
    for (double& value : values)
      value = std::round(std::abs(random.normal()) * 3); // many are equal
    compareWithMedian(values);
  }
}

} // namespace
} // namespace pcl::acmap::test
