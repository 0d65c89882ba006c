#pragma once

#include <CLI/App.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief What the help of a tool has besides its options. */
struct HelpText {
  /** \brief Command lines and what they do. */
  std::vector<std::pair<std::string, std::string>> examples;

  /** \brief The options that the help shows by default, with their dashes; empty: all. */
  std::vector<std::string> common;
};

/** \brief Text of `--help`, `--help all` and `--help GROUP`: usage, purpose, examples, and options
 * with their defaults; no line is longer than the width, unless a single word is.
 * \param[in] topic empty: the common options; "all"; or the begin of a word in the title of a
 * group of options. Others count as empty. */
std::string
helpOf(const CLI::App& app,
       const HelpText& help,
       const std::string& topic,
       std::size_t width);

/** \brief The same with all options as a page of the manual, troff with the macros of man(7). */
std::string
manPageOf(const CLI::App& app, const HelpText& help);

} // namespace pcl::acmap
