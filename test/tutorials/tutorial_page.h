#pragma once

#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief What a reader of a tutorial does or sees next. */
struct TutorialStep {
  enum class Kind {
    Script, ///< a block `sh`, to be run
    File,   ///< a block under a line like "`name.cpp`:", to be written
    Output  ///< a block `text`, lines that the script before tells
  };

  Kind kind = Kind::Script;
  std::string name; ///< of the file
  std::string text;
  int line = 0; ///< of the page, where the block begins
};

/** \brief A tutorial as its reader follows it. */
struct TutorialPage {
  std::vector<TutorialStep> steps;

  /** \brief Names of the pictures of the folder pictures/tutorials that it shows: what
   * its steps must have made under these names. */
  std::vector<std::string> pictures;
};

/** \brief Reads a page. Blocks `console` are for the reader alone; those of a list item
 * may be indented.
 * \throws std::runtime_error for a block of which it is not clear what to do with it, and
 * for a page without a script or a picture */
TutorialPage
parseTutorial(const std::string& markdown);

} // namespace pcl::acmap::test
