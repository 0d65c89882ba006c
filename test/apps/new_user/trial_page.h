#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief What a new user wants to know, the command that the user tries, and what must
 * come of it. */
struct TrialRow {
  int line = 0; ///< of the page
  std::string question;
  std::string command; ///< of the shell; TOOL stands for each tool

  int exit_code = -1;
  std::vector<std::string> prints; ///< words on stdout
  std::vector<std::string> says;   ///< words on stderr
  std::vector<std::string> writes; ///< files and folders
};

/** \brief Rows that are tried one after the other in one folder. */
struct TrialSection {
  std::string title;
  std::vector<TrialRow> rows;
};

/** \brief Reads the tables of a page, one per heading. The third cell of a row has the
 * words exit, prints, says and writes; numbers and `words` stand behind them.
 * \throws std::runtime_error naming the line of a row that cannot be tried */
std::vector<TrialSection>
parseTrial(const std::string& markdown);

/** \brief The commands that a page shows under a line, one each, without remarks.
 * \throws std::runtime_error where there are none */
std::vector<std::string>
commandsUnder(const std::string& line, const std::string& markdown);

} // namespace pcl::acmap::test
