#include "files/text_number.h"

#include "files/record_moves.h"

#include <pcl/PCLPointField.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <system_error>

namespace pcl::acmap {

namespace {

// Old versions of Microsoft's run-time library wrote 1.#QNAN, -1.#IND and 1.#INF.
bool
parseOldWindowsNumber(std::string_view word, std::string_view rest, double& value)
{
  if (rest.substr(0, 1) != "#")
    return false;
  const double infinity = std::numeric_limits<double>::infinity();
  value = rest.substr(1, 3) == "INF" ? (word.front() == '-' ? -infinity : infinity)
                                     : std::numeric_limits<double>::quiet_NaN();
  return true;
}

std::string_view
withoutPlus(std::string_view word)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
    word.remove_prefix(1);
  return word;
}

template <typename Value>
bool
storeInteger(std::string_view word, std::uint8_t* to)
{
  word = withoutPlus(word);
  const char* const end = word.data() + word.size();
  Value value = 0;
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stop != end) {
    // Some programs write integers as 12.0 or 1e3, and unknown ones as nan.
    double real = 0.0;
    if (!parseNumber(word, real))
      return false;
    if (std::isnan(real))
      real = 0.0;
    const double limit = std::ldexp(1.0, std::numeric_limits<Value>::digits);
    const double minimum = std::numeric_limits<Value>::is_signed ? -limit : 0.0;
    if (real < minimum || real >= limit || real != std::floor(real))
      return false;
    value = static_cast<Value>(real);
  }
  std::memcpy(to, &value, sizeof(value));
  return true;
}

template <typename Value>
bool
storeReal(std::string_view word, std::uint8_t* to)
{
  Value value = 0;
  if (!parseNumber(word, value))
    return false;
  std::memcpy(to, &value, sizeof(value));
  return true;
}

} // namespace

bool
parseNumber(std::string_view word, float& value)
{
  word = withoutPlus(word);
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error == std::errc() && stop == end)
    return true;
  double wide = 0.0;
  if (!parseNumber(word, wide))
    return false;
  value = narrowed(wide);
  return true;
}

bool
parseNumber(std::string_view word, double& value)
{
  word = withoutPlus(word);
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc())
    return false;
  return stop == end || parseOldWindowsNumber(
                            word, {stop, static_cast<std::size_t>(end - stop)}, value);
}

bool
parseCount(std::string_view word, std::uint64_t& value)
{
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  return error == std::errc() && stop == end;
}

bool
storeNumber(std::string_view word, std::uint8_t datatype, std::uint8_t* to)
{
  switch (datatype) {
  case PCLPointField::INT8:
    return storeInteger<std::int8_t>(word, to);
  case PCLPointField::BOOL:
  case PCLPointField::UINT8:
    return storeInteger<std::uint8_t>(word, to);
  case PCLPointField::INT16:
    return storeInteger<std::int16_t>(word, to);
  case PCLPointField::UINT16:
    return storeInteger<std::uint16_t>(word, to);
  case PCLPointField::INT32:
    return storeInteger<std::int32_t>(word, to);
  case PCLPointField::UINT32:
    return storeInteger<std::uint32_t>(word, to);
  case PCLPointField::INT64:
    return storeInteger<std::int64_t>(word, to);
  case PCLPointField::UINT64:
    return storeInteger<std::uint64_t>(word, to);
  case PCLPointField::FLOAT32:
    return storeReal<float>(word, to);
  case PCLPointField::FLOAT64:
    return storeReal<double>(word, to);
  default:
    return false;
  }
}

std::string
inPrint(std::string_view text, std::size_t longest)
{
  std::string shown;
  for (const char c : text.substr(0, longest))
    shown += c >= ' ' && c <= '~' ? c : '?';
  return shown + (text.size() > longest ? "..." : "");
}

std::string
inQuotes(std::string_view word)
{
  constexpr std::size_t longest = 40;
  return "'" + inPrint(word, longest) + "'";
}

std::string
lowerEnding(const std::string& path)
{
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

} // namespace pcl::acmap
