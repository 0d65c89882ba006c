#pragma once

#include <string>

namespace pcl::acmap::test {

/** \brief Films three observations of a corridor under three patterns into a raw
 * session: the minimum that gives a map. */
void
filmSmallSession(const std::string& session);

} // namespace pcl::acmap::test
