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
  /** \brief Changes of the environment; without a value the variable is taken away. */
  std::vector<std::pair<std::string, std::optional<std::string>>> environment;

  /** \brief Longest file the program may write, in bytes; a stand-in for a full disk. */
  std::optional<std::size_t> file_size_limit;

  /** \brief Address space of the program, in bytes. */
  std::optional<std::size_t> memory_limit;

  /** \brief Where the program runs; empty: where the test does. */
  std::string folder;

  /** \brief Seconds after which the program is ended by SIGALRM; 0 for never. */
  unsigned time_limit = 0;

  /** \brief Seconds after which the program gets an interruption (SIGINT), counted from
   * when it began to heed it. */
  std::optional<double> interrupt_after;

  /** \brief The interruption comes as soon as this holds, or after half a minute. */
  std::function<bool()> interrupt_when;

  /** \brief The signal that comes as interruption. */
  int interruption = SIGINT;

  /** \brief A file that takes stdout, as /dev/full. */
  std::string out_file;

  /** \brief Whether stdout and stderr are a pipe that nobody reads any more. */
  bool reader_is_gone = false;
};

/** \brief What came of it. */
struct ToolRun {
  int exit_code = -1; ///< -1 when a signal ended the program
  int signal = 0;     ///< that signal, else 0
  std::string out;
  std::string err;

  std::size_t
  errorLines() const;
};

/** \brief Runs a program to its end, without a shell. */
ToolRun
runTool(const std::string& program,
        const std::vector<std::string>& arguments,
        const RunSettings& settings = {});

} // namespace pcl::acmap::test
