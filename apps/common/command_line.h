#pragma once

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief Rewrites PCL's spelling of long options (`-max_edge`, `-max-edge`) to the one
 * that CLI11 knows (`--max-edge`); all other arguments are unchanged.
 * \param[in] arguments without the name of the program
 * \param[in] app knows the long options */
std::vector<std::string>
withDoubleDashes(std::vector<std::string> arguments, const CLI::App& app);

/** \brief Error message for options that a tool does not have, with suggestions of
 * similar ones, in the spelling of the user.
 * \param[in] words that the parser did not recognise, with their dashes
 * \return empty if none of the words looks like an option */
std::string
unknownOptionFault(const std::vector<std::string>& words, const CLI::App& app);

/** \brief Usage line with required and optional arguments: "pcl_tool IN [OUT] --rig
 * RIG.yaml [OPTIONS]". */
std::string
usageOf(const CLI::App& app);

/** \brief Inserts the value `auto` after an option whose value may be omitted, if the
 * next argument is neither a number nor `auto`.
 * \param[in] name of the option, with its dashes */
std::vector<std::string>
withAutomaticValue(std::vector<std::string> arguments, const std::string& name);

/** \brief Reads two whole numbers with an x between them, such as 9x6; nothing if the
 * text has another form. */
std::optional<std::array<int, 2>>
crossedNumbers(const std::string& text);

/** \brief Text for help and messages: "one of paper, dense". */
std::string
oneOf(const std::vector<std::string>& names);

/** \brief Accepts only the given names. */
CLI::Validator
nameAmong(const std::vector<std::string>& names);

/** \brief Adds an option whose value is chosen by its name.
 * \param[in] preset the default
 * \param[in] take is called with the choice
 * \param[in] choices names and values, in the order of the help */
template <typename Value>
CLI::Option*
addChoice(CLI::App& app,
          const std::string& option,
          const Value& preset,
          const std::function<void(const Value&)>& take,
          const std::vector<std::pair<std::string, Value>>& choices,
          const std::string& description)
{
  std::vector<std::string> names;
  std::string default_name;
  for (const auto& [name, chosen] : choices) {
    names.push_back(name);
    if (chosen == preset)
      default_name = name;
  }
  const auto choose = [take, choices](const std::string& text) {
    for (const auto& [name, chosen] : choices)
      if (name == text)
        take(chosen);
  };
  return app
      .add_option_function<std::string>(
          option, choose, oneOf(names) + "; " + description)
      ->type_name("NAME")
      ->default_str(default_name)
      ->check(nameAmong(names));
}

/** \brief The same for a variable, which is the default and gets the choice. */
template <typename Value>
CLI::Option*
addChoice(CLI::App& app,
          const std::string& option,
          Value& value,
          const std::vector<std::pair<std::string, Value>>& choices,
          const std::string& description)
{
  return addChoice<Value>(
      app,
      option,
      value,
      [&value](const Value& chosen) { value = chosen; },
      choices,
      description);
}

/** \brief Accepts finite numbers above zero, up to a maximum. */
CLI::Validator
positiveNumber(double maximum = std::numeric_limits<double>::max());

/** \brief Accepts numbers of a range; CLI::Range accepts NaN, too. */
CLI::Validator
numberWithin(double minimum, double maximum);

/** \brief Refuses negative numbers, which would wrap round to large ones. */
CLI::Validator
wholeNumber();

/** \brief Converts a size such as 500MB (powers of ten) to a number of bytes above
 * zero. */
CLI::Validator
memorySize();

/** \brief Accepts names of images. Without it, an empty list of images would take the
 * next option as an image. */
CLI::Validator
imageName();

} // namespace pcl::acmap
