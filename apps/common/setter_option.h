#pragma once

#include "command_line.h"
#include "exit_code.h"

#include <pcl/exceptions.h>

#include <exception>
#include <functional>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief Gives a value of the command line to a setter.
 * \throws CLI::ValidationError, a fault of usage, with the setter's own message if it
 * refuses the value */
template <typename Set, typename Value>
void
callSetter(const std::string& option, const Set& set, const Value& value)
{
  try {
    set(value);
  }
  catch (const BadArgumentException&) {
    throw CLI::ValidationError(option, failureOf(std::current_exception()).line);
  }
}

/** \brief Adds an option whose value a function gives to setters, and which has no
 * default: for optional values, and for options of two objects. An unsigned value refuses
 * negative numbers. */
template <typename Value>
CLI::Option*
addSetter(CLI::App& app,
          const std::string& option,
          const std::function<void(Value)>& set,
          const std::string& help,
          const std::string& type)
{
  CLI::Option* const added =
      app.add_option_function<Value>(
             option,
             [option, set](const Value& given) { callSetter(option, set, given); },
             help)
          ->type_name(type)
          ->default_str("");
  if constexpr (std::is_unsigned_v<Value>)
    added->check(wholeNumber().description(""));
  return added;
}

/** \brief A value of the command line in the unit of the setter. */
template <typename Value>
Value
inUnitOfSetter(Value given, [[maybe_unused]] double unit)
{
  if constexpr (std::is_floating_point_v<Value>)
    return given * static_cast<Value>(unit);
  else
    return given;
}

/** \brief Adds an option whose value a setter of the object takes that then runs. Its
 * default is that of the getter, its range that of the setter. Setters are called in the
 * order in which the options were added: they must not depend on each other.
 * \param[in] unit of the option, in that of the setter: M_PI / 180 for degrees */
template <typename Stage, typename Base, typename Value, typename Got>
CLI::Option*
addSetter(CLI::App& app,
          const std::string& option,
          Stage& stage,
          void (Base::*set)(Value),
          Got (Base::*get)() const,
          const std::string& help,
          const std::string& type,
          double unit = 1)
{
  std::ostringstream preset;
  if constexpr (std::is_floating_point_v<Value>)
    preset << (stage.*get)() / unit;
  else
    preset << (stage.*get)();
  const std::function<void(Value)> take = [&stage, set, unit](Value given) {
    (stage.*set)(inUnitOfSetter(given, unit));
  };
  return addSetter(app, option, take, help, type)->default_str(preset.str());
}

/** \brief Adds an option without a value, with which a setter gets \a value. */
template <typename Stage, typename Base>
CLI::Option*
addSwitch(CLI::App& app,
          const std::string& option,
          Stage& stage,
          void (Base::*set)(bool),
          bool value,
          const std::string& help)
{
  return app.add_flag_callback(
      option, [&stage, set, value] { (stage.*set)(value); }, help);
}

/** \brief Adds an option by whose name a setter gets one of several values. */
template <typename Stage, typename Base, typename Value>
CLI::Option*
addSetterChoice(CLI::App& app,
                const std::string& option,
                Stage& stage,
                void (Base::*set)(Value),
                Value (Base::*get)() const,
                const std::vector<std::pair<std::string, Value>>& choices,
                const std::string& help)
{
  return addChoice<Value>(
      app,
      option,
      (stage.*get)(),
      [&stage, set](Value chosen) { (stage.*set)(chosen); },
      choices,
      help);
}

} // namespace pcl::acmap
