#pragma once

#include <pcl/core/random.h>

#include <cstddef>
#include <cstdint>

namespace pcl::acmap {

/** \brief Pseudo-random bits that depend on both arguments, for random streams that are
 * identified by a number. */
inline std::uint64_t
mixedBits(std::uint64_t seed, std::uint64_t number)
{
  return Random(Random(seed).bits() + number).bits();
}

/** \brief Fast generator of normal random numbers, mean 0 and variance 1. Each number
 * is one of 4096 equally probable values, of 12 random bits; therefore its magnitude is
 * at most 3.7. Mean and skewness are 0, the variance is 1, and the kurtosis is 2.99
 * instead of 3.
 * \param[in] stream seed of the sequence
 * \param[out] to receives the numbers
 * \param[in] size number of random numbers */
void
fillNormal(std::uint64_t stream, float* to, std::size_t size);

} // namespace pcl::acmap
