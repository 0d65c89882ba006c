#include "clouds/digit_groups.h"

#include <algorithm>
#include <cstddef>

namespace pcl::acmap {

namespace {

std::size_t
leadingDigits(std::string_view text)
{
  const auto end =
      std::find_if(text.begin(), text.end(), [](char c) { return c < '0' || c > '9'; });
  return static_cast<std::size_t>(end - text.begin());
}

/** Bytes of the mark with which a text begins; 0: none. */
std::size_t
markLength(std::string_view text)
{
  // in ASCII, UTF-8 and the code pages of Western Europe
  for (const std::string_view mark :
       {"'", " ", "\xe2\x80\x99", "\xc2\xa0", "\xe2\x80\xaf", "\x92", "\xa0"})
    if (text.substr(0, mark.size()) == mark)
      return mark.size();
  return 0;
}

} // namespace

std::optional<std::string>
withoutGroups(std::string_view number)
{
  constexpr std::size_t group = 3; // digits
  std::string plain;
  if (!number.empty() && (number[0] == '-' || number[0] == '+')) {
    plain = number[0];
    number.remove_prefix(1);
  }
  std::size_t digits = leadingDigits(number);
  if (digits == 0 || digits > group)
    return std::nullopt;
  bool has_marks = false;
  for (;;) {
    plain += number.substr(0, digits);
    number.remove_prefix(digits);
    const std::size_t mark = markLength(number);
    if (mark == 0)
      break;
    number.remove_prefix(mark);
    digits = leadingDigits(number);
    if (digits != group)
      return std::nullopt;
    has_marks = true;
  }
  if (!has_marks)
    return std::nullopt;
  return plain.append(number);
}

} // namespace pcl::acmap
