#pragma once

#include <cstddef>
#include <iosfwd>

namespace pcl::acmap::test {

/** \brief Resources of a process. */
struct ProcessUse {
  std::ptrdiff_t allocated = 0; ///< bytes requested and not yet freed
  std::ptrdiff_t resident = 0;  ///< bytes in memory after the allocator released free
                                ///< memory; 0 under a sanitizer, which keeps more
  std::ptrdiff_t files = 0;     ///< open descriptors
  std::ptrdiff_t threads = 0;
};

/** \brief Current use of resources of this process.
 * \throws std::runtime_error when the system does not provide them */
ProcessUse
currentUse();

/** \brief Growth from \a before to \a after. */
ProcessUse
operator-(const ProcessUse& after, const ProcessUse& before);

/** \brief Prints growth, in KB. */
std::ostream&
operator<<(std::ostream& stream, const ProcessUse& growth);

} // namespace pcl::acmap::test
