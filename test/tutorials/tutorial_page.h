#pragma once

#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief A step of a tutorial. */
struct TutorialStep {
  enum class Kind {
    Script, ///< a block `sh` to execute
    File,   ///< a block after a line such as "`name.cpp`:", to be written to this file
    Output  ///< a block `text` with expected output of the previous script
  };

  Kind kind = Kind::Script;
  std::string name; ///< of the file
  std::string text;
  int line = 0; ///< of the page, at the start of the block
};

/** \brief The steps and pictures of a tutorial. */
struct TutorialPage {
  std::vector<TutorialStep> steps;

  /** \brief Names of the pictures that it shows from pictures/tutorials: its steps must
   * create files with these names. */
  std::vector<std::string> pictures;
};

/** \brief Reads a page. Blocks `console` are not executed; blocks in list items may be
 * indented.
 * \throws std::runtime_error for a block of unknown purpose, and for a page without a
 * script or a picture */
TutorialPage
parseTutorial(const std::string& markdown);

} // namespace pcl::acmap::test
