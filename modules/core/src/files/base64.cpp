#include <pcl/core/impl/base64.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace pcl::acmap {

std::string
base64(std::string_view bytes)
{
  constexpr char digits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr unsigned shifts[] = {18, 12, 6, 0};
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8U | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= count ? digits[bits >> shifts[k] & 63U] : '=';
  }
  return text;
}

} // namespace pcl::acmap
