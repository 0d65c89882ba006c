#include "ugly_run.h"

#include "run_tool.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <sstream>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;

constexpr unsigned time_limit = 300; // for sanitizers on a busy machine

/** All entries below a folder by relative path: the bytes of files, a word for
 * others. */
std::map<std::string, std::string>
allIn(const TemporaryFolder& folder)
{
  const fs::path root = folder.path("");
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(root))
    all[fs::relative(entry.path(), root).string()] =
        entry.symlink_status().type() == fs::file_type::regular
            ? contentOf(entry.path().string())
            : "no file";
  return all;
}

/** Masks text that depends on the machine: memory, the last digits of sums, and the
 * place of the parse error of a JSON file that is truncated, which is of another length
 * with each change of a map. */
std::string
masked(const std::string& text)
{
  static const std::regex numbers(
      R"((?!0\.0001\b)\d+\.\d{4,}(e[+-]\d+)?|[\d.]+(e\+\d+)?(?= GB))");
  static const std::regex cut(R"((parse error at line )\d+, column \d{3,}: [^\n]*)");
  return std::regex_replace(std::regex_replace(text, cut, "$1…"), numbers, "…");
}

bool
isPrintable(const std::string& text)
{
  return std::all_of(text.begin(), text.end(), [](char c) {
    return c == '\n' || (static_cast<unsigned char>(c) >= 32 && c != 127);
  });
}

/** Checks the messages. */
void
judgeWords(const UglyTool& tool,
           const UglyCase& ugly,
           const ToolRun& run,
           std::vector<std::string>& faults)
{
  const bool is_refused = ugly.exit_code != 0;
  if (run.signal != 0)
    faults.push_back("ended by signal " + std::to_string(run.signal));
  if (run.exit_code != ugly.exit_code)
    faults.push_back("exit code " + std::to_string(run.exit_code) + ", not " +
                     std::to_string(ugly.exit_code));
  if (is_refused && !run.out.empty())
    faults.push_back("has written to stdout: " + run.out);
  if (is_refused && run.errorLines() != 1)
    faults.push_back("has told " + std::to_string(run.errorLines()) +
                     " lines, one is wanted");
  if (!is_refused && run.err.empty() != ugly.told.empty())
    faults.emplace_back(run.err.empty() ? "a warning is missing" : "warns");
  if (run.err.find(ugly.told) == std::string::npos)
    faults.push_back("does not tell of '" + ugly.told + "'");
  if (!isPrintable(run.err))
    faults.emplace_back("what it tells cannot be printed");
  std::istringstream lines(run.err);
  for (std::string line; std::getline(lines, line);)
    if (line.rfind(tool.name + (is_refused ? ": " : ": warning: "), 0) != 0)
      faults.push_back("a line does not begin as it should: " + line);
}

/** Removes the stages that a chain finished, from which its next run continues. */
std::map<std::string, std::string>
withoutStages(std::map<std::string, std::string> all, const std::string& output)
{
  const std::string stages = output + "/stages";
  if (all.count(stages) == 0)
    return all;
  const auto begin = all.find(stages);
  auto end = begin;
  while (end != all.end() && end->first.rfind(stages, 0) == 0)
    ++end;
  all.erase(begin, end);
  if (all.upper_bound(output + "/") == all.end() ||
      all.upper_bound(output + "/")->first.rfind(output + "/", 0) != 0)
    all.erase(output);
  return all;
}

/** Checks the files. */
void
judgeFiles(const UglyTool& tool,
           const UglyCase& ugly,
           const std::map<std::string, std::string>& before,
           const std::map<std::string, std::string>& after,
           std::vector<std::string>& faults)
{
  if (ugly.exit_code != 0 && withoutStages(after, tool.output) != before)
    faults.emplace_back("has left or changed something");
  if (ugly.exit_code != 0)
    return;
  if (after.count(tool.output) == 0)
    faults.push_back("there is no " + tool.output);
  for (const auto& [path, bytes] : before)
    if (after.count(path) == 0 || after.at(path) != bytes)
      faults.push_back("has changed " + path);
  for (const auto& [path, bytes] : after)
    if (fs::path(path).filename().string().front() == '.')
      faults.push_back("has left " + path);
}

ToolRun
runIn(const TemporaryFolder& folder,
      const UglyTool& tool,
      const UglyCase& ugly,
      std::vector<std::string>& faults)
{
  RunSettings settings;
  settings.folder = folder.path("");
  settings.time_limit = time_limit;
  const auto before = allIn(folder);
  const ToolRun run =
      runTool(ACMAP_TOOLS_FOLDER "/" + tool.name, ugly.arguments, settings);
  judgeWords(tool, ugly, run, faults);
  judgeFiles(tool, ugly, before, allIn(folder), faults);
  return run;
}

} // namespace

UglyRun
runCase(const UglyTool& tool, const UglyCase& ugly)
{
  UglyRun seen;
  const auto runOnce = [&](bool has_older_result) {
    const TemporaryFolder folder;
    ugly.prepare(folder);
    if (has_older_result && tool.makes_folder)
      fs::create_directories(folder.path(tool.output));
    if (has_older_result)
      folder.write(tool.makes_folder ? tool.output + "/mine" : tool.output, "older");
    const ToolRun run = runIn(folder, tool, ugly, seen.faults);
    seen.exit_code = run.exit_code;
    return run.err;
  };
  seen.err = masked(runOnce(false));
  if (ugly.exit_code != 0 && seen.faults.empty() && masked(runOnce(true)) != seen.err)
    seen.faults.emplace_back("tells something else with an older result in its place");
  return seen;
}

std::vector<UglyRun>
runCases(const UglyTool& tool)
{
  std::vector<UglyRun> runs;
  for (const UglyCase& ugly : tool.cases)
    runs.push_back(ugly.arguments.empty() ? UglyRun() : runCase(tool, ugly));
  return runs;
}

} // namespace pcl::acmap::test
