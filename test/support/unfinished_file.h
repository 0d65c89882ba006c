#pragma once

#include <string>

namespace pcl::acmap::test {

/** \brief Whether a run has written a file of this name that is to be in a folder once the
 * run is done: it lies in a hidden folder there or beside it. */
bool
isUnfinished(const std::string& folder, const std::string& name);

} // namespace pcl::acmap::test
