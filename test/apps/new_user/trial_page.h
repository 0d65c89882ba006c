#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief A question of a new user, the command that the user tries, and the expected
 * result. */
struct TrialRow {
  int line = 0; ///< line of the page
  std::string question;
  std::string command; ///< shell command; TOOL stands for each tool

  int exit_code = -1;
  std::vector<std::string> prints; ///< expected words on stdout
  std::vector<std::string> says;   ///< expected words on stderr
  std::vector<std::string> writes; ///< expected files and folders
};

/** \brief Rows that are run one after the other in one folder. */
struct TrialSection {
  std::string title;
  std::vector<TrialRow> rows;
};

/** \brief Reads the tables of a page, one per heading. The third cell of a row has the
 * keywords exit, prints, says and writes, each followed by numbers and `words`.
 * \throws std::runtime_error naming the line of an invalid row */
std::vector<TrialSection>
parseTrial(const std::string& markdown);

/** \brief The commands that a page shows after a line, one per entry, without comments.
 * \throws std::runtime_error if there are none */
std::vector<std::string>
commandsUnder(const std::string& line, const std::string& markdown);

} // namespace pcl::acmap::test
