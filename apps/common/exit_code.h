#pragma once

#include <exception>
#include <stdexcept>
#include <string>

namespace pcl::acmap {

/** \brief Exit codes of the tools; scripts rely on these numbers. */
enum ExitCode {
  exit_done = 0,
  exit_failed = 1,
  exit_usage = 2,
  exit_input = 3,
  exit_nothing_found = 4,
  exit_output = 5,
  exit_memory = 6,
  exit_contradicted = 7,
  exit_interrupted = 130
};

/** \brief The tool finished, but there is no result to write; the message is the
 * reason. */
class NothingFound : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief Each option is valid, but not their combination. */
class UsageError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief The run failed, and the results finished by then are written; the message names
 * them. */
class FailedPartway : public std::runtime_error {
public:
  FailedPartway(ExitCode code, const std::string& line)
  : std::runtime_error(line)
  , code_(code)
  {}

  ExitCode
  code() const
  {
    return code_;
  }

private:
  ExitCode code_;
};

/** \brief The same after an interruption by the user. */
class InterruptedPartway : public FailedPartway {
public:
  explicit InterruptedPartway(const std::string& line)
  : FailedPartway(exit_interrupted, line)
  {}
};

/** \brief Exit code and message of a run that ended with an exception. */
struct Failure {
  ExitCode code;
  std::string line; ///< message for the user, without line breaks
};

/** \brief Maps an exception to an exit code. */
Failure
failureOf(const std::exception_ptr& error);

} // namespace pcl::acmap
