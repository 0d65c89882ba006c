#pragma once

#include <string>

namespace pcl::acmap::test {

/** \brief Finds the first fault of a page: elements that are not closed, or in the
 * wrong order, attributes without quotes, unescaped `<`, `>` or `&`, invalid UTF-8;
 * empty if there is none. */
std::string
htmlFault(const std::string& page);

} // namespace pcl::acmap::test
