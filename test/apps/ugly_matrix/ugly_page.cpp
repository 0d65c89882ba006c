#include "ugly_page.h"

#include <algorithm>
#include <sstream>

namespace pcl::acmap::test {
namespace {

constexpr const char* introduction = R"(# What ugly input gives

Each tool on each kind of ugly input: exit code, what stderr says, and, checked with every run, that a run which fails
leaves nothing behind and an older result as it was; only finished stages of `pcl_compact_mapping` stay, for its next run.
The tests `tools_ugly_...` make these runs and compare them with this page;
`build/dev/bin/write_robustness_page doc/robustness.md` writes it anew.

Exit codes: 0 done, 2 usage, 3 input unreadable or malformed, 4 nothing found, 5 output could not be written, 6 refused
for memory; `0!` is done, with a warning. Where a cell has several, the tool's list below tells which input gives which.
`–` makes no sense for that tool, and the list says why. `…` differs from machine to machine.

A device or a pipe is never read, as nobody knows how long one would wait for it, and readers take no more memory than a
file can back, so they must know its size. It is refused at once as no regular file; `cat` it into a file first.

)";

/** Exit codes in the order of the cases, without duplicates. */
std::string
cellOf(Ugliness kind, const UglyTool& tool, const std::vector<UglyRun>& runs)
{
  std::vector<std::string> codes;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (tool.cases[i].kind != kind)
      continue;
    const bool is_run = !tool.cases[i].arguments.empty();
    const std::string mark = runs[i].exit_code == 0 && !runs[i].err.empty() ? "!" : "";
    const std::string code =
        is_run ? std::to_string(runs[i].exit_code) + mark : std::string("–");
    if (std::find(codes.begin(), codes.end(), code) == codes.end())
      codes.push_back(code);
  }
  std::string cell;
  for (const std::string& code : codes)
    cell += (cell.empty() ? "" : ", ") + code;
  return cell;
}

std::string
inCell(std::string text)
{
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, "\\");
  return text;
}

/** Lines of stderr in code style, without the name of the tool. */
std::string
linesOf(const UglyTool& tool, const UglyRun& run)
{
  std::string cell;
  std::istringstream lines(run.err);
  for (std::string line; std::getline(lines, line);) {
    const std::string begin = tool.name + ": ";
    if (line.rfind(begin, 0) == 0)
      line.erase(0, begin.size());
    cell += (cell.empty() ? "`" : "<br>`") + inCell(line) + "`";
  }
  return cell;
}

std::string
listOf(const UglyTool& tool, const std::vector<UglyRun>& runs)
{
  std::string list =
      "## " + tool.name + "\n\n| input | | exit | stderr |\n|---|---|---|---|\n";
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const UglyCase& ugly = tool.cases[i];
    const bool is_run = !ugly.arguments.empty();
    list += std::string("| ") + nameOf(ugly.kind) + " | " + inCell(ugly.what) + " | " +
            (is_run ? std::to_string(runs[i].exit_code) : "–") + " | " +
            linesOf(tool, runs[i]) + " |\n";
  }
  return list;
}

/** The cells of a table row. */
std::vector<std::string>
cellsIn(const std::string& line)
{
  std::vector<std::string> cells;
  std::size_t begin = 1;
  for (std::size_t end; (end = line.find('|', begin)) != std::string::npos;
       begin = end + 1)
    cells.push_back(line.substr(begin + 1, end - begin - 2));
  return cells;
}

/** The name as a heading with possible line breaks. */
std::string
headingOf(const std::string& tool)
{
  std::string heading = tool.substr(tool.find('_') + 1);
  std::replace(heading.begin(), heading.end(), '_', ' ');
  return "[" + heading + "](#" + tool + ")";
}

} // namespace

UglyColumn
columnOf(const UglyTool& tool, const std::vector<UglyRun>& runs)
{
  UglyColumn column{tool.name, {}, listOf(tool, runs)};
  for (const Ugliness kind : uglinesses())
    column.cells[nameOf(kind)] = cellOf(kind, tool, runs);
  return column;
}

std::string
pageOf(const std::vector<UglyColumn>& columns)
{
  std::string heading = "| |", rule = "|---|", rows, lists;
  for (const UglyColumn& column : columns) {
    heading += " " + headingOf(column.name) + " |";
    rule += "---|";
    lists += "\n" + column.list;
  }
  for (const Ugliness kind : uglinesses()) {
    rows += std::string("| ") + nameOf(kind) + " |";
    for (const UglyColumn& column : columns)
      rows += " " + column.cells.at(nameOf(kind)) + " |";
    rows += "\n";
  }
  return introduction + heading + "\n" + rule + "\n" + rows + lists;
}

UglyColumn
columnIn(const std::string& page, const std::string& tool)
{
  UglyColumn column{tool, {}, {}};
  std::istringstream lines(page);
  std::size_t place = 0;
  std::string section;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("## ", 0) == 0)
      section = line.substr(3);
    if (section == tool && !line.empty())
      column.list += line + "\n" + (line[0] == '#' ? "\n" : "");
    if (!section.empty() || line.rfind("| ", 0) != 0)
      continue;
    const std::vector<std::string> cells = cellsIn(line);
    if (place == 0)
      place = static_cast<std::size_t>(
          std::find(cells.begin(), cells.end(), headingOf(tool)) - cells.begin());
    else if (place < cells.size())
      column.cells[cells[0]] = cells[place];
  }
  return column;
}

} // namespace pcl::acmap::test
