#include "command_line.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

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

} // namespace

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

CLI::Validator
positiveNumber()
{
  return CLI::Validator(
      [](std::string& text) -> std::string {
        double value = 0;
        if (CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0)
          return {};
        return text + " is not a number above 0";
      },
      "NUMBER");
}

CLI::Validator
memorySize()
{
  return CLI::Validator(
      [bytes = CLI::AsSizeValue(true)](std::string& text) -> std::string {
        const std::string size = text;
        // a sign would wrap round to a large number
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
