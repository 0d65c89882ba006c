#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief What a processor does in a computation. */
struct EventCounts {
  std::uint64_t instructions = 0;
  std::uint64_t mispredictions = 0; ///< of branches
};

/** \brief Counts the events of a function in the calling thread, by the counters of the
 * processor; nothing if the system has none, as most virtual machines. */
std::optional<EventCounts>
countByProcessor(const std::function<void()>& function);

/** \brief Counts the events of the calls of a function in a run of this program, by
 * callgrind, which simulates the predictions of branches.
 * \param[in] function as callgrind names it, with * for any text
 * \param[in] arguments of this program
 * \throws std::runtime_error if there is no valgrind, or the run failed */
EventCounts
countByCallgrind(const std::string& function,
                 const std::vector<std::string>& arguments);

} // namespace pcl::acmap::bench
