#pragma once

#include <pcl/core/random.h>

#include <cstdint>

namespace pcl::acmap {

/** \brief Bits that look random and depend on all of their arguments, for streams that
 * need nothing but their number. */
inline std::uint64_t
mixedBits(std::uint64_t seed, std::uint64_t number)
{
  return Random(Random(seed).bits() + number).bits();
}

} // namespace pcl::acmap
