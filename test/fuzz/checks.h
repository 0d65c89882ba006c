#pragma once

#include "fuzzed_bytes.h"

#include <pcl/core/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>

namespace pcl::acmap::test {

/** \brief Result of a reader; nothing if it rejects the input, with a printable message
 * of one line that contains the file name. Any other exception ends the program.
 * \param[in] read reads a file called "input" */
template <typename Read>
auto
acceptedBy(const Read& read) -> std::optional<std::invoke_result_t<Read>>
{
  try {
    return read();
  }
  catch (const InputFileException& refusal) {
    const std::string line = refusal.what();
    const std::string begin = "input: ";
    require(line.compare(0, begin.size(), begin) == 0 && line.size() > begin.size());
    require(std::none_of(
        line.begin(), line.end(), [](unsigned char letter) { return letter < ' '; }));
    return std::nullopt;
  }
}

inline std::string
textOfInput(const std::uint8_t* data, std::size_t size)
{
  return {reinterpret_cast<const char*>(data), size};
}

/** \brief Are both numbers equal, or both NaN? */
template <typename Number>
bool
isSame(Number a, Number b)
{
  return a == b || (a != a && b != b);
}

} // namespace pcl::acmap::test
