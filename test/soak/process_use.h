#pragma once

#include <cstddef>
#include <iosfwd>

namespace pcl::acmap::test {

/** \brief What a process holds. */
struct ProcessUse {
  std::ptrdiff_t allocated = 0; ///< bytes that were asked for and not given back
  std::ptrdiff_t resident = 0;  ///< bytes in memory, after the allocator gave back
      ///< what it could; 0 under a sanitizer, which keeps more
  std::ptrdiff_t files = 0; ///< open descriptors
  std::ptrdiff_t threads = 0;
};

/** \brief What this process holds now.
 * \throws std::runtime_error where the system does not tell */
ProcessUse
currentUse();

/** \brief How much more \a after is. */
ProcessUse
operator-(const ProcessUse& after, const ProcessUse& before);

/** \brief As growth, in KB. */
std::ostream&
operator<<(std::ostream& stream, const ProcessUse& growth);

} // namespace pcl::acmap::test
