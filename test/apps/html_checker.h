#pragma once

#include <string>

namespace pcl::acmap::test {

/** \brief The first fault of a page as ours are: elements that are not closed, or in the
 * wrong order, attributes without quotes, bare `<`, `>` or `&`, bytes that are no UTF-8;
 * empty for a sound one. */
std::string
htmlFault(const std::string& page);

} // namespace pcl::acmap::test
