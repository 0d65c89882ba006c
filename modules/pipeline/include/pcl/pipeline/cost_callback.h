#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace pcl {

/** \brief Called before a step that is expected to be expensive; it may throw to refuse it.
 * \param[in] work what is to be done, in words
 * \param[in] bytes memory that the step takes at most, 0 if that is unknown
 * \param[in] seconds expected duration, 0 if that is unknown \ingroup pipeline */
using CostCallback =
    std::function<void(const std::string& work, std::size_t bytes, double seconds)>;

} // namespace pcl
