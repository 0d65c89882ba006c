#pragma once

#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief Asks the system to back memory that is not used yet by pages of 2 MB. It only
 * concerns speed: the first use of a page of 4 KB takes longer than reading its content
 * from a file. Blocks of less than a few megabytes are left as they are. */
void
adviseLargePages(void* begin, std::size_t bytes);

/** \brief Reserves memory for \a count values that are appended soon. */
template <typename Value>
void
reserveLarge(std::vector<Value>& values, std::size_t count)
{
  values.reserve(count);
  adviseLargePages(values.data(), values.capacity() * sizeof(Value));
}

} // namespace pcl::acmap
