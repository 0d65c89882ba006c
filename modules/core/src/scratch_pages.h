#pragma once

#include <cstddef>

namespace pcl::acmap {

/** \brief Blocks of fewer bytes are never in files. */
inline constexpr std::size_t worth_a_file = std::size_t{4} << 20;

/** \brief Maps a file of the scratch memory that is in effect.
 * \return nullptr if there is none, or if its disk has no room */
void*
mapScratch(std::size_t bytes);

/** \brief Unmaps a block of at least \ref worth_a_file bytes, in a file or not. */
void
unmapLarge(void* memory, std::size_t bytes);

} // namespace pcl::acmap
