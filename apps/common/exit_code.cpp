#include "exit_code.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/process_memory.h>

#include <algorithm>
#include <new>
#include <system_error>

namespace pcl::acmap {
namespace {

std::string
oneLine(std::string text)
{
  // PCL begins its messages with ": "
  text.erase(0, std::min(text.find_first_not_of(": \n"), text.size()));
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string
memoryFault()
{
  return memoryLimit()
             ? "not enough memory: --memory-limit is " + gigabytes(memoryLimit())
             : "not enough memory";
}

template <typename... Types>
bool
isOneOf(const std::exception& error)
{
  return ((dynamic_cast<const Types*>(&error) != nullptr) || ...);
}

ExitCode
codeOf(const std::exception& error)
{
  if (const auto* const partway = dynamic_cast<const FailedPartway*>(&error))
    return partway->code();
  if (isOneOf<InputFileException>(error))
    return exit_input;
  if (isOneOf<MemoryLimitException>(error))
    return exit_memory;
  if (isOneOf<OutputFileException>(error))
    return exit_output;
  if (isOneOf<NothingFound, EmptyInputException>(error))
    return exit_nothing_found;
  if (isOneOf<UsageError, BadArgumentException>(error))
    return exit_usage;
  return exit_failed;
}

/** \brief Could something not be allocated? The system error is that of a thread for
 * whose stack there is no memory. */
bool
lacksMemory(const std::exception& error)
{
  if (isOneOf<std::bad_alloc>(error))
    return true;
  const auto* const of_system = dynamic_cast<const std::system_error*>(&error);
  return of_system && (of_system->code() == std::errc::resource_unavailable_try_again ||
                       of_system->code() == std::errc::not_enough_memory);
}

} // namespace

Failure
failureOf(const std::exception_ptr& error)
{
  try {
    std::rethrow_exception(error);
  }
  catch (const CancelledException&) {
    return {exit_interrupted, "interrupted, nothing was written"};
  }
  catch (const std::exception& e) {
    if (lacksMemory(e))
      return {exit_memory, memoryFault()};
    return {codeOf(e), oneLine(e.what())};
  }
  catch (...) {
    return {exit_failed, "failed for an unknown reason"};
  }
}

} // namespace pcl::acmap
