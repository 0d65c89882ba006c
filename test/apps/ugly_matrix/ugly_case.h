#pragma once

#include "temporary_folder.h"

#include <functional>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Kinds of faults of an input: the rows of the matrix. */
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

/** \brief Name on the page. */
const char*
nameOf(Ugliness kind);

/** \brief A run of a tool on a faulty input, in a separate folder. */
struct UglyCase {
  Ugliness kind = Ugliness::Missing;

  /** \brief Description of the input for the page; the reason if the case is not
   * applicable. */
  std::string what;

  /** \brief Puts the input into the folder in which the tool will run. */
  std::function<void(const TemporaryFolder&)> prepare;

  /** \brief Command line, with names relative to that folder; empty if the case is not
   * applicable. */
  std::vector<std::string> arguments;

  /** \brief Expected exit code. */
  int exit_code = 0;

  /** \brief Expected text on stderr: the name of the faulty file, or a word of the
   * warning; empty if there must be no message. */
  std::string told;
};

/** \brief A column of the matrix. */
struct UglyTool {
  std::string name; ///< name of the program

  /** \brief File or folder of the result in its command lines. */
  std::string output;

  bool makes_folder = false; ///< true if that is a folder

  bool draws = false; ///< true if some cases need an X server

  std::vector<UglyCase> cases;
};

/** \brief The cases of each tool, by its name. */
std::vector<UglyTool>
uglyTools();

} // namespace pcl::acmap::test
