#include "page_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>

namespace pcl::acmap {

namespace {

constexpr const char* replacement = "\xEF\xBF\xBD"; // U+FFFD
constexpr const char* minus = "\xE2\x88\x92";       // U+2212

/** Length of the well-formed character that begins at a byte; 0 if there is none.
 * Overlong forms and surrogates are not well-formed. */
std::size_t
characterLength(const std::string& text, std::size_t at)
{
  const auto byte = [&](std::size_t i) {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U;
  };
  const unsigned first = byte(0);
  if (first < 0x80)
    return 1;
  if (first < 0xC2 || first > 0xF4)
    return 0;
  const std::size_t length = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  const unsigned least = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned most = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  if (byte(1) < least || byte(1) > most)
    return 0;
  for (std::size_t i = 2; i < length; ++i)
    if ((byte(i) & 0xC0U) != 0x80)
      return 0;
  return length;
}

std::string
htmlCharacter(char character)
{
  switch (character) {
  case '&':
    return "&amp;";
  case '<':
    return "&lt;";
  case '>':
    return "&gt;";
  case '"':
    return "&quot;";
  case '\'':
    return "&#39;";
  case '\n':
  case '\t':
    return {character};
  default:
    const bool is_control =
        static_cast<unsigned char>(character) < 0x20 || character == 0x7F;
    return is_control ? replacement : std::string(1, character);
  }
}

std::string
printed(const char* format, int digits, double value)
{
  std::array<char, 400> text{}; // the largest double has 309 digits
  std::snprintf(text.data(), text.size(), format, digits, value);
  return text.data();
}

/** Inserts commas between groups of three digits before the decimal point. */
std::string
grouped(std::string digits)
{
  const std::size_t begin = digits.find_first_of("0123456789");
  for (std::size_t end = std::min(digits.find('.'), digits.size()); end > begin + 3;
       end -= 3)
    digits.insert(end - 3, ",");
  return digits;
}

std::string
withMinus(const std::string& text)
{
  if (text.empty() || text[0] != '-')
    return text;
  // a number that was rounded to zero has no sign
  const bool is_zero = text.find_first_of("123456789") == std::string::npos;
  return is_zero ? text.substr(1) : minus + text.substr(1);
}

} // namespace

std::string
htmlText(const std::string& text)
{
  std::string html;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = characterLength(text, i);
    if (length == 0)
      html += replacement;
    else
      html += length == 1 ? htmlCharacter(text[i]) : text.substr(i, length);
    i += length == 0 ? 1 : length;
  }
  return html;
}

std::string
shellText(const std::vector<std::string>& arguments)
{
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                "0123456789_./:=,+@%-";
  std::string line;
  for (const std::string& argument : arguments) {
    line += line.empty() ? "" : " ";
    if (!argument.empty() && argument.find_first_not_of(plain) == std::string::npos) {
      line += argument;
      continue;
    }
    line += '\'';
    for (const char character : argument)
      line += character == '\'' ? std::string("'\\''") : std::string(1, character);
    line += '\'';
  }
  return line;
}

std::string
numberText(double value)
{
  // whole numbers are not exact in a double beyond this
  constexpr double max_grouped = 1e15;
  const double size = std::abs(value);
  if (size >= 999.5 && size < max_grouped)
    return withMinus(grouped(printed("%.*f", 0, value)));
  return withMinus(printed("%.*g", 3, value));
}

std::string
fixedText(double value, int digits)
{
  return withMinus(grouped(printed("%.*f", digits, value)));
}

std::string
secondsText(double seconds)
{
  if (std::abs(seconds) < 9.995)
    return fixedText(seconds, 2) + " s";
  if (std::abs(seconds) < 119.95)
    return fixedText(seconds, 1) + " s";
  const double minutes = std::floor(std::round(seconds) / 60);
  const double rest = std::round(seconds) - 60 * minutes;
  return fixedText(minutes, 0) + " min " + (rest < 10 ? "0" : "") + fixedText(rest, 0) +
         " s";
}

std::string
bytesText(double bytes)
{
  if (std::abs(bytes) < 1000)
    return fixedText(bytes, 0) + " bytes";
  const char* const units[] = {"kB", "MB", "GB", "TB"};
  std::size_t unit = 0;
  for (bytes /= 1000; std::abs(bytes) >= 999.5 && unit + 1 < std::size(units); ++unit)
    bytes /= 1000;
  return numberText(bytes) + " " + units[unit];
}

} // namespace pcl::acmap
