#pragma once

#include "temporary_folder.h"

#include <functional>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief What can be wrong with an input: the rows of the matrix. */
enum class Ugliness {
  Missing,
  Empty,
  Truncated,
  Garbage,
  NanOnly,
  OnePoint,
  Doubled,
  WrongFields,
  Huge,
  Millimetres,
  Names,
  Device,
  Folder
};

/** \brief All of them, in the order of the page. */
const std::vector<Ugliness>&
uglinesses();

/** \brief How the page calls it. */
const char*
nameOf(Ugliness kind);

/** \brief A run of a tool on an ugly input, in a folder of its own. */
struct UglyCase {
  Ugliness kind = Ugliness::Missing;

  /** \brief What is read, for the page; of a case that makes no sense, why. */
  std::string what;

  /** \brief Puts the input into the folder that the tool will run in. */
  std::function<void(const TemporaryFolder&)> prepare;

  /** \brief Of the command line, names relative to that folder; none where the case
   * makes no sense. */
  std::vector<std::string> arguments;

  /** \brief What the run must return. */
  int exit_code = 0;

  /** \brief What stderr must hold: the name of the ugly file, or a word of the warning;
   * empty where nothing must be said. */
  std::string told;
};

/** \brief A column of the matrix. */
struct UglyTool {
  std::string name; ///< of the program

  /** \brief File or folder that its command lines name as the result. */
  std::string output;

  bool makes_folder = false; ///< whether that is a folder

  bool draws = false; ///< whether some cases need an X server

  std::vector<UglyCase> cases;
};

/** \brief The cases of each tool, by its name. */
std::vector<UglyTool>
uglyTools();

} // namespace pcl::acmap::test
