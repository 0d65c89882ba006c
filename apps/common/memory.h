#pragma once

#include <cstddef>
#include <string>

namespace pcl::acmap {

/** \brief Largest resident memory of this process so far, in bytes. */
std::size_t
peakMemory();

/** \brief From now on this process gets at most so many bytes beside those it has; asked
 * for more, it meets std::bad_alloc. Under AddressSanitizer and ThreadSanitizer, which end
 * the process then, only \ref requireMemory heeds the limit.
 * \param[in] bytes 0 for no limit
 * \param[in] threads that work at once (0 = all cores): they are started first, since
 * a thread whose stack is refused would end the process */
void
limitMemory(std::size_t bytes, unsigned threads);

/** \brief What was allowed by \ref limitMemory, 0 without a limit. */
std::size_t
memoryLimit();

/** \brief Lifts the limit for a while, and does not count what is taken until its end:
 * libraries that draw end the process where memory is refused. */
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

/** \brief Refuses work that there is no memory for, before it is begun: what this machine
 * has left, or the limit leaves.
 * \param[in] bytes what the work will take
 * \param[in] work what it is, for the message
 * \throws MemoryRefused naming both amounts */
void
requireMemory(std::size_t bytes, const std::string& work);

/** \brief "0.5 GB", for messages. */
std::string
gigabytes(std::size_t bytes);

} // namespace pcl::acmap
