#pragma once

#include <pcl/core/random.h>

#include <cstdint>

namespace pcl::acmap {

/** \brief Pseudo-random bits that depend on both arguments, for random streams that are
 * identified by a number. */
inline std::uint64_t
mixedBits(std::uint64_t seed, std::uint64_t number)
{
  return Random(Random(seed).bits() + number).bits();
}

} // namespace pcl::acmap
