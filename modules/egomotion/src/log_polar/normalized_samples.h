#pragma once

#include <cmath>
#include <cstddef>

namespace pcl::acmap {

/** \brief Normalizes samples to mean 0 and length 1; all are 0 if they are equal.
 * \return their previous length about the mean */
inline float
normalizeSamples(float* samples, std::size_t size)
{
  float sum = 0;
  for (std::size_t k = 0; k < size; ++k)
    sum += samples[k];
  const float mean = sum / static_cast<float>(size);
  float squares = 0;
  for (std::size_t k = 0; k < size; ++k) {
    samples[k] -= mean;
    squares += samples[k] * samples[k];
  }
  const float length = std::sqrt(squares);
  const float scale = length > 0 ? 1 / length : 0;
  for (std::size_t k = 0; k < size; ++k)
    samples[k] *= scale;
  return length;
}

} // namespace pcl::acmap
