#include "trial_page.h"

#include <algorithm>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace pcl::acmap::test {
namespace {

[[noreturn]] void
refuse(const TrialRow& row, const std::string& why)
{
  throw std::runtime_error("line " + std::to_string(row.line) + ": " + why);
}

/** \brief Cells of a table row, without surrounding blanks. */
std::vector<std::string>
cellsOf(const std::string& line)
{
  std::vector<std::string> cells;
  std::istringstream text(line.substr(1));
  for (std::string cell; std::getline(text, cell, '|');) {
    const std::size_t begin = cell.find_first_not_of(' ');
    cells.push_back(begin == std::string::npos
                        ? ""
                        : cell.substr(begin, cell.find_last_not_of(' ') + 1 - begin));
  }
  return cells;
}

/** \brief Reads text such as "exit 2, says `a` `b`" into a row. */
void
takeOutcome(const std::string& cell, TrialRow& row)
{
  static const std::regex token("`([^`]+)`|([a-z]+)|([0-9]+)|([^ ,;])");
  std::vector<std::string>* words = nullptr;
  bool is_number_next = false;
  for (std::sregex_iterator at(cell.begin(), cell.end(), token), end; at != end; ++at) {
    const std::string quoted = (*at)[1], word = (*at)[2], number = (*at)[3];
    if (is_number_next != !number.empty())
      refuse(row, "a number follows exit, and nothing else");
    is_number_next = word == "exit";
    if (!number.empty())
      row.exit_code = std::stoi(number);
    else if (!quoted.empty() && words)
      words->push_back(quoted);
    else if (word == "exit")
      words = nullptr;
    else if (word == "prints")
      words = &row.prints;
    else if (word == "says")
      words = &row.says;
    else if (word == "writes")
      words = &row.writes;
    else
      refuse(row, "\"" + at->str() + "\" is not understood");
  }
  if (row.exit_code < 0)
    refuse(row, "the exit code is missing");
}

TrialRow
rowOf(const std::vector<std::string>& cells, int line)
{
  TrialRow row;
  row.line = line;
  if (cells.size() != 3)
    refuse(row, "question, command and outcome are needed");
  row.question = cells[0];
  const std::string& command = cells[1];
  if (command.size() < 3 || command.front() != '`' || command.back() != '`')
    refuse(row, "the command is not in backquotes");
  row.command = command.substr(1, command.size() - 2);
  takeOutcome(cells[2], row);
  return row;
}

} // namespace

std::vector<TrialSection>
parseTrial(const std::string& markdown)
{
  std::vector<TrialSection> sections;
  std::istringstream text(markdown);
  int number = 0, rows_of_table = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    if (line.rfind("## ", 0) == 0)
      sections.push_back({line.substr(3), {}});
    rows_of_table = line.rfind('|', 0) == 0 ? rows_of_table + 1 : 0;
    constexpr int head = 2;
    if (rows_of_table <= head)
      continue;
    if (sections.empty())
      throw std::runtime_error("line " + std::to_string(number) + ": has no heading");
    sections.back().rows.push_back(rowOf(cellsOf(line), number));
  }
  return sections;
}

std::vector<std::string>
commandsUnder(const std::string& line, const std::string& markdown)
{
  std::istringstream text(
      markdown.substr(std::min(markdown.find(line), markdown.size())));
  std::vector<std::string> commands;
  bool is_open = false;
  for (std::string row; std::getline(text, row);) {
    if (row.rfind("```", 0) == 0) {
      if (is_open)
        break;
      is_open = true;
    }
    else if (is_open && row.find_first_not_of(' ') != std::string::npos) {
      const std::string command = row.substr(0, row.find('#'));
      commands.push_back(command.substr(0, command.find_last_not_of(' ') + 1));
    }
  }
  if (commands.empty())
    throw std::runtime_error(line + ": shows no command");
  return commands;
}

} // namespace pcl::acmap::test
