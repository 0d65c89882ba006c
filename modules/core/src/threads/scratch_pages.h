#pragma once

#include <cstddef>

namespace pcl::acmap {

/** \brief Blocks of fewer bytes are from the heap; others are mapped, in a file or not. */
inline constexpr std::size_t worth_pages = std::size_t{1} << 18;

/** \brief Maps a file of the scratch memory that is in effect.
 * \return nullptr if there is none, or if its disk has no room */
void*
mapScratch(std::size_t bytes);

/** \brief Is this address in a block of scratch memory? */
bool
isInScratch(const void* address);

/** \brief Unmaps a block of at least \ref worth_pages bytes, in a file or not. */
void
unmapLarge(void* memory, std::size_t bytes);

} // namespace pcl::acmap
