#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief Weights of a Gaussian blur, up to three standard deviations; their sum is 1.
 * \param[in] sigma px; 0 gives one weight
 * \return an odd number of weights */
inline std::vector<float>
gaussianWeights(double sigma)
{
  const int radius = static_cast<int>(std::ceil(3.0 * sigma));
  std::vector<double> weights;
  double sum = 0.0;
  for (int i = -radius; i <= radius; ++i) {
    weights.push_back(sigma > 0.0 ? std::exp(-0.5 * i * i / (sigma * sigma)) : 1.0);
    sum += weights.back();
  }
  std::vector<float> normal;
  for (const double weight : weights)
    normal.push_back(static_cast<float>(weight / sum));
  return normal;
}

} // namespace pcl::acmap
