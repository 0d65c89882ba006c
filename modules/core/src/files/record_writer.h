#pragma once

#include <pcl/core/output_file.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Writes records of \a step bytes using a buffer that fits into the cache.
 * \param[in] fill called with (buffer, first record, number of records); bytes that it
 * does not set are zero */
template <typename Fill>
void
writeRecords(OutputFile& file, std::size_t count, std::size_t step, const Fill& fill)
{
  constexpr std::size_t buffer_bytes = 256 * 1024;
  const std::size_t chunk = std::min(count, buffer_bytes / step + 1);
  std::vector<std::uint8_t> buffer(chunk * step);
  for (std::size_t first = 0; first < count; first += chunk) {
    const std::size_t now = std::min(chunk, count - first);
    fill(buffer.data(), first, now);
    file.write(buffer.data(), now * step);
  }
}

} // namespace pcl::acmap
