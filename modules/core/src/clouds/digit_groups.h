#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pcl::acmap {

/** \brief A number without its marks of thousands, which are apostrophes or blanks, also those
 * of print, as in 2'600'123.45.
 * \return nothing if the text has no such marks, or its digits are in other groups */
std::optional<std::string>
withoutGroups(std::string_view number);

} // namespace pcl::acmap
