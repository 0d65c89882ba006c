#include "noise/best_split.h"

#include <cmath>

namespace pcl::acmap {

Split
bestSplit(const std::vector<double>& sorted)
{
  const auto n = static_cast<double>(sorted.size());
  double sum = 0, square = 0;
  for (const double value : sorted) {
    sum += value;
    square += value * value;
  }
  Split split;
  const double variance = square / n - sum * sum / (n * n);
  if (!(variance > 0))
    return split;
  double best = 0, left = 0;
  for (std::size_t i = 0; i + 1 < sorted.size(); ++i) {
    left += sorted[i];
    const double a = static_cast<double>(i + 1), b = n - a;
    const double between = a * b / (n * n) * std::pow(left / a - (sum - left) / b, 2);
    if (between > best) {
      best = between;
      split.first = i + 1;
    }
  }
  split.left = 1 - best / variance;
  return split;
}

} // namespace pcl::acmap
