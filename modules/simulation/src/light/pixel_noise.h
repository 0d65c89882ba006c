#pragma once

#include <cstddef>
#include <cstdint>

namespace pcl::acmap {

/** \brief Normal numbers, mean 0 and variance 1, as quickly as pixels need them: one of
 * 4096 equally likely values, so none is beyond 3.7, and 12 random bits each. Moments are
 * right: mean and skewness 0, variance 1, kurtosis 2.99 for 3.
 * \param[in] stream seed of the sequence
 * \param[out] to this many numbers */
void
fillNormal(std::uint64_t stream, float* to, std::size_t size);

} // namespace pcl::acmap
