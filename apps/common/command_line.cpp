#include "command_line.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <limits>
#include <numeric>
#include <sstream>

namespace pcl::acmap {
namespace {

std::string
withDoubleDash(const std::string& argument, const CLI::App& app)
{
  const std::size_t begin = argument.find_first_not_of('-');
  if (begin == std::string::npos || begin == 0 || begin > 2)
    return argument;
  const std::size_t end = std::min(argument.find('='), argument.size());
  std::string name = argument.substr(begin, end - begin);
  std::replace(name.begin(), name.end(), '_', '-');
  if (name.size() < 2 || !app.get_option_no_throw("--" + name))
    return argument;
  return "--" + name + argument.substr(end);
}

/** \brief Edit distance: number of letters to insert, remove, replace or swap with
 * their neighbour to turn one word into the other. */
std::size_t
editDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> before_last, last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] =
          std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = last;
    std::swap(last, row);
  }
  return last[b.size()];
}

/** \brief Distance of a word from the name of an option; nothing if it is too large for
 * a misspelling. If one of the words is a part of the other, the shorter one probably
 * stands for the whole name. */
std::optional<std::size_t>
misspelling(const std::string& word, const std::string& name)
{
  constexpr std::size_t letters_per_fault = 3, min_part = 3;
  const std::size_t distance = editDistance(word, name);
  const std::size_t length = std::min(word.size(), name.size());
  if (distance <= std::max<std::size_t>(1, word.size() / letters_per_fault))
    return distance;
  const bool is_part = length >= min_part && (name.find(word) != std::string::npos ||
                                              word.find(name) != std::string::npos);
  return is_part ? std::optional(distance + name.size()) : std::nullopt;
}

/** \brief Names of the options that are most similar to a word, without dashes. */
std::vector<std::string>
nearestNames(const std::string& word, const CLI::App& app)
{
  constexpr std::size_t maximum = 3;
  std::vector<std::pair<std::size_t, std::string>> found;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames())
      if (const auto distance = misspelling(word, name))
        found.emplace_back(*distance, name);
  std::sort(found.begin(), found.end());
  std::vector<std::string> names;
  for (const auto& [distance, name] : found)
    if (distance == found.front().first && names.size() < maximum)
      names.push_back(name);
  return names;
}

/** \brief Does a word begin as options do? Negative numbers do not. */
bool
looksLikeOption(const std::string& word)
{
  const std::size_t begin = word.find_first_not_of('-');
  return (begin == 1 || begin == 2) &&
         std::isalpha(static_cast<unsigned char>(word[begin]));
}

/** \brief Writes a name in the spelling of the user: with his dashes before the name,
 * and his underscores in it. */
std::string
spelledAs(const std::string& word, std::string name)
{
  if (word.find('_') != std::string::npos)
    std::replace(name.begin(), name.end(), '-', '_');
  return word.substr(0, word.find_first_not_of('-')) + name;
}

} // namespace

std::string
unknownOptionFault(const std::vector<std::string>& words, const CLI::App& app)
{
  std::string fault;
  for (const std::string& given : words) {
    if (!looksLikeOption(given))
      continue;
    const std::string word = given.substr(0, given.find('='));
    std::string letters =
        CLI::detail::to_lower(word.substr(word.find_first_not_of('-')));
    std::replace(letters.begin(), letters.end(), '_', '-');
    std::string meant;
    for (const std::string& name : nearestNames(letters, app))
      meant += (meant.empty() ? "" : " or ") + spelledAs(word, name);
    fault += (fault.empty() ? "" : "; ") + word + " is not an option of this tool" +
             (meant.empty() ? "" : ", did you mean " + meant + "?");
  }
  return fault;
}

std::vector<std::string>
withDoubleDashes(std::vector<std::string> arguments, const CLI::App& app)
{
  for (std::string& argument : arguments) {
    if (argument == "--")
      break;
    argument = withDoubleDash(argument, app);
  }
  return arguments;
}

std::string
usageOf(const CLI::App& app)
{
  std::string positionals, needed;
  for (const CLI::Option* option : app.get_options()) {
    const std::string type = option->get_type_name();
    if (option->get_positional())
      positionals += option->get_required() ? " " + type : " [" + type + "]";
    else if (option->get_required())
      needed += " " + option->get_name() + " " + type;
  }
  return app.get_name() + positionals + needed + " [OPTIONS]";
}

std::vector<std::string>
withAutomaticValue(std::vector<std::string> arguments, const std::string& name)
{
  const auto is_value = [](const std::string& text) {
    double number = 0;
    return text == "auto" || CLI::detail::lexical_cast(text, number);
  };
  for (std::size_t i = 0; i < arguments.size() && arguments[i] != "--"; ++i)
    if (arguments[i] == name &&
        (i + 1 == arguments.size() || !is_value(arguments[i + 1])))
      arguments[i] += "=auto";
  return arguments;
}

std::optional<std::array<int, 2>>
crossedNumbers(const std::string& text)
{
  const char* const end = text.data() + text.size();
  std::array<int, 2> numbers{};
  const auto first = std::from_chars(text.data(), end, numbers[0]);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != 'x')
    return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, numbers[1]);
  if (second.ec != std::errc() || second.ptr != end)
    return std::nullopt;
  return numbers;
}

std::string
oneOf(const std::vector<std::string>& names)
{
  return "one of " + CLI::detail::join(names, ", ");
}

CLI::Validator
nameAmong(const std::vector<std::string>& names)
{
  return CLI::Validator(
      [names](const std::string& text) {
        return std::find(names.begin(), names.end(), text) != names.end()
                   ? std::string()
                   : text + " is not " + oneOf(names);
      },
      "");
}

CLI::Validator
positiveNumber(double maximum)
{
  return CLI::Validator(
      [maximum](std::string& text) -> std::string {
        double value = 0;
        if (CLI::detail::lexical_cast(text, value) && value > 0 && value <= maximum)
          return {};
        std::ostringstream limit;
        if (maximum < std::numeric_limits<double>::max())
          limit << " and up to " << maximum;
        return text + " is not a number above 0" + limit.str();
      },
      "NUMBER");
}

CLI::Validator
numberWithin(double minimum, double maximum)
{
  return CLI::Validator(
      [minimum, maximum](std::string& text) -> std::string {
        double value = 0;
        if (CLI::detail::lexical_cast(text, value) && value >= minimum &&
            value <= maximum)
          return {};
        std::ostringstream fault;
        fault << text << " is not a number from " << minimum << " to " << maximum;
        return fault.str();
      },
      "NUMBER");
}

CLI::Validator
wholeNumber()
{
  return CLI::Validator(
      [](const std::string& text) {
        return text.rfind('-', 0) == 0 ? text + " is no whole number from 0 on"
                                       : std::string();
      },
      "NUMBER");
}

CLI::Validator
memorySize()
{
  return CLI::Validator(
      [bytes = CLI::AsSizeValue(true)](std::string& text) -> std::string {
        const std::string size = text;
        // a negative number would wrap round to a large one
        if (text.empty() || !std::isdigit(static_cast<unsigned char>(text[0])))
          return size + " is no size such as 500MB";
        const std::string fault = bytes(text);
        return fault.empty() && text == "0" ? size + " is no memory at all" : fault;
      },
      "SIZE");
}

CLI::Validator
imageName()
{
  return CLI::Validator(
      [](const std::string& path) -> std::string {
        if (path.empty())
          return "an image without a name";
        return path.rfind("--", 0) == 0 ? "images are missing before " + path : "";
      },
      "");
}

} // namespace pcl::acmap
