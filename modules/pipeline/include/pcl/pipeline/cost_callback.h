#pragma once

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

} // namespace pcl
