#pragma once

#include <string>

namespace pcl::acmap::test {

/** \brief Films three observations of a corridor under three patterns into a raw session:
 * the least that a map comes of. */
void
filmSmallSession(const std::string& session);

} // namespace pcl::acmap::test
