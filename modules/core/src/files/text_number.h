#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace pcl::acmap {

/** \brief Splits a line into words without copying them. */
class Words {
public:
  enum class Separators { blanks, blanks_and_commas };

  explicit Words(std::string_view line, Separators separators = Separators::blanks)
  : at_(line.data())
  , end_(line.data() + line.size())
  , minimum_(separators == Separators::blanks ? blank : comma)
  {}

  /** \return false at the end of the line */
  bool
  next(std::string_view& word)
  {
    while (at_ != end_ && separates(*at_))
      ++at_;
    const char* const begin = at_;
    while (at_ != end_ && !separates(*at_))
      ++at_;
    word = {begin, static_cast<std::size_t>(at_ - begin)};
    return at_ != begin;
  }

private:
  static constexpr std::uint8_t comma = 1;
  static constexpr std::uint8_t blank = 2;

  static constexpr std::array<std::uint8_t, 256>
  kinds()
  {
    std::array<std::uint8_t, 256> kinds{};
    kinds[' '] = kinds['\t'] = kinds['\r'] = blank;
    kinds[','] = kinds[';'] = kinds['|'] = comma;
    return kinds;
  }

  bool
  separates(char c) const
  {
    static constexpr auto table = kinds();
    return table[static_cast<unsigned char>(c)] >= minimum_;
  }

  const char* at_;
  const char* end_;
  std::uint8_t minimum_;
};

/** \brief Parses a complete word as a number, including `nan` and `inf`, independent of
 * the locale.
 * \return false when the word is not a number */
bool
parseNumber(std::string_view word, float& value);
bool
parseNumber(std::string_view word, double& value);

/** \brief Parses a word as a non-negative integer: digits only. */
bool
parseCount(std::string_view word, std::uint64_t& value);

/** \brief Parses a word as a value of a PCLPointField datatype and stores its bytes.
 * \return false when the word is not a number or does not fit the type */
bool
storeNumber(std::string_view word, std::uint8_t datatype, std::uint8_t* to);

/** \brief Makes text from a file or a library printable for a message: one line of
 * printable ASCII characters.
 * \param[in] text the text
 * \param[in] longest maximum number of characters */
std::string
inPrint(std::string_view text, std::size_t longest);

/** \brief Returns a word in quotes for a message: short, and printable for any content.
 */
std::string
inQuotes(std::string_view word);

/** \brief Returns the shortest text from which the same number is read back,
 * independent of the locale. */
template <typename Real>
std::string
textOf(Real value)
{
  std::array<char, 40> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

/** \brief Returns the extension of a file name with its dot, in lower case. */
std::string
lowerEnding(const std::string& path);

} // namespace pcl::acmap
