#pragma once

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Rewrites PCL's spelling of long options (`-max_edge`, `-max-edge`) to the one
 * that CLI11 knows (`--max-edge`); everything else stays as it is.
 * \param[in] arguments without the name of the program
 * \param[in] app knows the long options */
std::vector<std::string>
withDoubleDashes(std::vector<std::string> arguments, const CLI::App& app);

/** \brief Gives an option whose value may be left out the value `auto` where what follows
 * it is no value: a number or `auto`.
 * \param[in] name of the option, with its dashes */
std::vector<std::string>
withAutomaticValue(std::vector<std::string> arguments, const std::string& name);

/** \brief Reads two whole numbers with a cross between them, as in 9x6; nothing where the
 * text is anything else. */
std::optional<std::array<int, 2>>
crossedNumbers(const std::string& text);

/** \brief Lets finite numbers above zero pass. */
CLI::Validator
positiveNumber();

/** \brief Makes a number of bytes, above zero, of a size such as 500MB (powers of ten). */
CLI::Validator
memorySize();

/** \brief Lets names of images pass. Without it, a list that was left empty would take the
 * next option for an image. */
CLI::Validator
imageName();

} // namespace pcl::acmap
