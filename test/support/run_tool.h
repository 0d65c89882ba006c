#pragma once

#include <csignal>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap::test {

/** \brief How a program is run. */
struct RunSettings {
  /** \brief Changes of the environment; variables without a value are removed. */
  std::vector<std::pair<std::string, std::optional<std::string>>> environment;

  /** \brief Maximum size of written files, in bytes; simulates a full disk. */
  std::optional<std::size_t> file_size_limit;

  /** \brief Address space of the program, in bytes. */
  std::optional<std::size_t> memory_limit;

  /** \brief Working directory; empty: that of the test. */
  std::string folder;

  /** \brief Seconds after which SIGALRM ends the program; 0 for never. */
  unsigned time_limit = 0;

  /** \brief Seconds after which the program is interrupted, counted from when it has
   * installed its handler for SIGINT. */
  std::optional<double> interrupt_after;

  /** \brief The interruption is sent when this returns true, or after 30 s. */
  std::function<bool()> interrupt_when;

  /** \brief The signal that is sent as interruption. */
  int interruption = SIGINT;

  /** \brief A file to which stdout is redirected, such as /dev/full. */
  std::string out_file;

  /** \brief Are stdout and stderr a pipe that is no longer read? */
  bool reader_is_gone = false;
};

/** \brief Result of a run. */
struct ToolRun {
  int exit_code = -1; ///< -1 if a signal ended the program
  int signal = 0;     ///< that signal, else 0
  std::string out;
  std::string err;
  std::string name; ///< of the program

  std::size_t
  errorLines() const;

  /** \brief The run itself, for tests that go on only after a success.
   * \throws std::runtime_error with what the program said, unless it ended with 0 */
  ToolRun
  succeeded() const;
};

/** \brief Runs a program without a shell and waits for its end. */
ToolRun
runTool(const std::string& program,
        const std::vector<std::string>& arguments,
        const RunSettings& settings = {});

/** \brief Arguments with more behind them. */
std::vector<std::string>
joined(std::vector<std::string> arguments, const std::vector<std::string>& more);

/** \brief A run fails with an exit code, nothing on stdout, and a last line on stderr that
 * begins with the name of the program and contains a word. */
void
expectFails(const ToolRun& run, int exit_code, const std::string& word);

/** \brief The same, and that line is the only one on stderr. */
void
expectRefused(const ToolRun& run, int exit_code, const std::string& word);

} // namespace pcl::acmap::test
