#pragma once

#include <exception>
#include <stdexcept>
#include <string>

namespace pcl::acmap {

/** \brief What a tool returns to its caller; scripts rely on these numbers. */
enum ExitCode {
  exit_done = 0,
  exit_failed = 1,
  exit_usage = 2,
  exit_input = 3,
  exit_nothing_found = 4,
  exit_output = 5,
  exit_memory = 6,
  exit_interrupted = 130
};

/** \brief The tool did its work and there is nothing to write; says why. */
class NothingFound : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief Options that are well-formed each but not together. */
class UsageError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief The work would not fit into the memory of this machine. */
class MemoryRefused : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief The user interrupted the run, and what was finished by then is written; says
 * what. */
class InterruptedPartway : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief How a run ended that an exception ended. */
struct Failure {
  ExitCode code;
  std::string line; ///< what to tell the user, without line breaks
};

/** \brief Sorts an exception into the exit codes. */
Failure
failureOf(const std::exception_ptr& error);

} // namespace pcl::acmap
