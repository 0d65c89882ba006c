#include <pcl/core/printable_text.h>

#include <algorithm>
#include <cstddef>

namespace pcl::acmap {

namespace {

/** \brief Number of bytes of the UTF-8 character that begins at an index; 0 if it is
 * not valid, or a control character. */
std::size_t
printableLength(const std::string& text, std::size_t at)
{
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  if (first < 0x80)
    return first < 0x20 || first == 0x7f ? 0 : 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || at + length > text.size())
    return 0;
  for (std::size_t i = 1; i < length; ++i)
    if (byte(at + i) >> 6 != 2)
      return 0;
  const bool is_control = first == 0xc2 && byte(at + 1) < 0xa0;
  return is_control ? 0 : length;
}

} // namespace

std::string
printable(const std::string& text)
{
  std::string shown;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = printableLength(text, at);
    shown += length > 0 ? text.substr(at, length) : "?";
    at += std::max<std::size_t>(length, 1);
  }
  return shown;
}

} // namespace pcl::acmap
