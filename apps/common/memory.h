#pragma once

#include <pcl/pipeline/cost_callback.h>

#include <cstddef>
#include <string>

namespace pcl::acmap {

/** \brief Peak resident memory of this process so far, in bytes. */
std::size_t
peakMemory();

/** \brief Limits the memory that this process can allocate in addition to what it has;
 * beyond it, allocations throw std::bad_alloc. Under AddressSanitizer and
 * ThreadSanitizer, which would end the process, only \ref requireMemory respects the
 * limit.
 * \param[in] bytes 0 for no limit
 * \param[in] threads number of worker threads (0 = all cores): they are started first,
 * since a thread whose stack cannot be allocated would end the process */
void
limitMemory(std::size_t bytes, unsigned threads);

/** \brief The limit of \ref limitMemory, 0 without a limit. */
std::size_t
memoryLimit();

/** \brief Bytes of scratch memory that may be in memory at the same time in any case: a part
 * of the limit, if there is one. */
std::size_t
residentScratch();

/** \brief Memory that this process may still allocate, in bytes: what the limit and this
 * machine have left. */
std::size_t
availableMemory();

/** \brief Suspends the limit during its lifetime, and does not count what is allocated
 * meanwhile: rendering libraries end the process when an allocation fails. */
class UnlimitedMemory {
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
 * \throws MemoryRefused naming both amounts */
void
requireMemory(std::size_t bytes, const std::string& work);

/** \brief The same, for classes of the library. */
CostCallback
memoryCheck();

/** \brief Text such as "0.5 GB", for messages. */
std::string
gigabytes(std::size_t bytes);

} // namespace pcl::acmap
