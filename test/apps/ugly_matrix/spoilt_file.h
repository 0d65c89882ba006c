#pragma once

#include "ugly_case.h"

namespace pcl::acmap::test {

/** \brief Bytes that mean nothing. */
std::string
garbage();

/** \brief Makes a file ugly in a way that any file can be: missing, empty, truncated,
 * garbage, a pipe that nobody writes to, or a folder. */
void
spoil(const std::string& path, Ugliness kind);

/** \brief What the page says of it then. */
const char*
stateOf(Ugliness kind);

} // namespace pcl::acmap::test
