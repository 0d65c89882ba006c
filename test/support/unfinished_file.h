#pragma once

#include <string>

namespace pcl::acmap::test {

/** \brief Has a run started to write a file of this name, which it will move into a
 * folder at its end? Such a file is in a hidden folder in \a folder or beside it. */
bool
isUnfinished(const std::string& folder, const std::string& name);

} // namespace pcl::acmap::test
