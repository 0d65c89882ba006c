#pragma once

#include "temporary_folder.h"

#include <string>

namespace pcl::acmap::test {

/** \brief A simulated hall, 160 x 120 pixels, seen from two positions. */
const std::string&
hallScene();

/** \brief Raw session of it: two observations, three patterns and a shot without; made
 * once per program, as the others here. \return the folder */
const std::string&
hallSession();

/** \brief Its observations as clouds with a trajectory.txt and VIEWPOINTs. */
const std::string&
hallObservations();

/** \brief A compact map of the session. */
const std::string&
hallMap();

/** \brief Copies a file, or a folder with its contents. */
void
give(const TemporaryFolder& folder, const std::string& from, const std::string& name);

/** \brief Replaces the first occurrence of a text in a file. */
void
replaceIn(const std::string& path, const std::string& text, const std::string& by);

} // namespace pcl::acmap::test
