#pragma once

#include <pcl/core/export.h>

#include <cstddef>
#include <string>

namespace pcl::acmap {

/** \brief Peak resident memory of this process so far, in bytes. */
ACMAP_EXPORT std::size_t
peakMemory();

/** \brief Limits the memory that this process can allocate in addition to what it has;
 * beyond it, allocations throw std::bad_alloc. The first of them lifts the limit, since the
 * program needs memory to end. For a program whose other parts must not run out of memory;
 * to be called once, before the work. Under AddressSanitizer and ThreadSanitizer, which would
 * end the process, only \ref requireMemory respects the limit.
 * \code
 * pcl::acmap::limitMemory (std::size_t{2} << 30, 0);      // 2 GB, for all threads
 * mapping.setCostCallback (pcl::memoryCheck ());          // refuses what will not fit
 * \endcode
 * \param[in] bytes 0 for no limit
 * \param[in] threads number of worker threads (0 = all cores): they are started first,
 * since a thread whose stack cannot be allocated would end the process */
ACMAP_EXPORT void
limitMemory(std::size_t bytes, unsigned threads);

/** \brief The limit of \ref limitMemory, 0 without a limit. */
ACMAP_EXPORT std::size_t
memoryLimit();

/** \brief Bytes of a \ref ScratchMemory that may be in memory at the same time in any case: a
 * part of the limit, if there is one. */
ACMAP_EXPORT std::size_t
residentScratch();

/** \brief Memory that this process may still allocate, in bytes: what the limit and this
 * machine have left. */
ACMAP_EXPORT std::size_t
availableMemory();

/** \brief Suspends the limit during its lifetime, and does not count what is allocated
 * meanwhile: rendering libraries end the process when an allocation fails. */
class ACMAP_EXPORT UnlimitedMemory {
public:
  UnlimitedMemory();

  ~UnlimitedMemory();

  UnlimitedMemory(const UnlimitedMemory&) = delete;

  UnlimitedMemory&
  operator=(const UnlimitedMemory&) = delete;

private:
  std::size_t before_ = 0;
};

/** \brief Refuses work for which there is not enough memory before it begins, according
 * to the free memory of this machine and the limit.
 * \param[in] bytes needed by the work
 * \param[in] work description, for the message
 * \throws MemoryLimitException naming both amounts */
ACMAP_EXPORT void
requireMemory(std::size_t bytes, const std::string& work);

/** \brief Text such as "0.5 GB", for messages. */
ACMAP_EXPORT std::string
gigabytes(std::size_t bytes);

} // namespace pcl::acmap
