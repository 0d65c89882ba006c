#pragma once

#include <pcl/core/export.h>

#include <string>

namespace pcl::acmap {

/** \brief Replaces control characters and invalid UTF-8 by question marks, so that a
 * text can be printed on a terminal. Messages quote files, which may contain
 * anything. \ingroup core */
ACMAP_EXPORT std::string
printable(const std::string& text);

} // namespace pcl::acmap
