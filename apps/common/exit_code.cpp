#include "exit_code.h"

#include "memory.h"

#include <pcl/core/exceptions.h>

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
  catch (const InterruptedPartway& e) {
    return {exit_interrupted, oneLine(e.what())};
  }
  catch (const InputFileException& e) {
    return {exit_input, oneLine(e.what())};
  }
  catch (const MemoryLimitException& e) {
    return {exit_memory, oneLine(e.what())};
  }
  catch (const OutputFileException& e) {
    return {exit_output, oneLine(e.what())};
  }
  catch (const NothingFound& e) {
    return {exit_nothing_found, oneLine(e.what())};
  }
  catch (const EmptyInputException& e) {
    return {exit_nothing_found, oneLine(e.what())};
  }
  catch (const UsageError& e) {
    return {exit_usage, oneLine(e.what())};
  }
  catch (const BadArgumentException& e) {
    return {exit_usage, oneLine(e.what())};
  }
  catch (const MemoryRefused& e) {
    return {exit_memory, oneLine(e.what())};
  }
  catch (const std::bad_alloc&) {
    return {exit_memory, memoryFault()};
  }
  catch (const std::system_error& e) {
    // thrown when there is no memory for the stack of a thread
    if (e.code() == std::errc::resource_unavailable_try_again ||
        e.code() == std::errc::not_enough_memory)
      return {exit_memory, memoryFault()};
    return {exit_failed, oneLine(e.what())};
  }
  catch (const std::exception& e) {
    return {exit_failed, oneLine(e.what())};
  }
  catch (...) {
    return {exit_failed, "failed for an unknown reason"};
  }
}

} // namespace pcl::acmap
