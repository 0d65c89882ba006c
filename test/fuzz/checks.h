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

/** \brief What a reader makes of its input; nothing where it refuses it, which it does in
 * one printable line that names the file. Whatever else it throws ends the program.
 * \param[in] read reads what it calls "input" */
template <typename Read>
auto
acceptedBy(const Read& read) -> std::optional<std::invoke_result_t<Read>>
{
  try {
    return read();
  }
  catch (const InputFileException& refusal) {
    const std::string line = refusal.what();
    const std::string begin = ": input: "; // PCL writes the colon
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

/** \brief Equal, or both NaN. */
template <typename Number>
bool
isSame(Number a, Number b)
{
  return a == b || (a != a && b != b);
}

} // namespace pcl::acmap::test
