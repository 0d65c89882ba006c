#pragma once

#include <cstddef>
#include <string>

namespace pcl::acmap {

/** \brief Largest resident memory of this process so far, in bytes. */
std::size_t
peakMemory();

/** \brief Refuses work that this machine has no memory for, before it is begun.
 * \param[in] bytes what the work will take
 * \param[in] work what it is, for the message
 * \throws MemoryRefused naming both amounts */
void
requireMemory(std::size_t bytes, const std::string& work);

} // namespace pcl::acmap
