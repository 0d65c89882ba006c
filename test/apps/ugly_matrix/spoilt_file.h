#pragma once

#include "ugly_case.h"

namespace pcl::acmap::test {

/** \brief Meaningless bytes. */
std::string
garbage();

/** \brief Damages a file in a way that is possible for any file: missing, empty,
 * truncated, garbage, a pipe without a writer, or a folder. */
void
spoil(const std::string& path, Ugliness kind);

/** \brief Description of its state for the page. */
const char*
stateOf(Ugliness kind);

} // namespace pcl::acmap::test
