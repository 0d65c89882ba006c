#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/process_memory.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>

namespace pcl {

/** \brief Called before a step that is expected to be expensive; it may throw to refuse
 * it.
 * \param[in] work description of the step
 * \param[in] bytes maximum memory of the step, 0 if unknown
 * \param[in] seconds expected duration, 0 if unknown
 *
 * \ingroup pipeline */
using CostCallback =
    std::function<void(const std::string& work, std::size_t bytes, double seconds)>;

/** \brief Refuses steps for which there is not enough memory (\ref acmap::requireMemory).
 * \ingroup pipeline */
inline CostCallback
memoryCheck()
{
  return [](const std::string& work, std::size_t bytes, double) {
    acmap::requireMemory(bytes, work);
  };
}

namespace acmap {

/** \brief An estimate in bytes as an integer, which may be beyond the memory of any machine. */
inline std::size_t
wholeBytes(double estimate)
{
  constexpr double maximum = 1e18; // within the range of an integer
  return static_cast<std::size_t>(std::min(estimate, maximum));
}

} // namespace acmap
} // namespace pcl
