#pragma once

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Names of a folder's PCD files that make its sequence, as \ref inSequence has
 * them. \throws InputFileException when it is no folder, or holds no PCD */
std::vector<std::string>
observationNames(const std::string& folder);

/** \brief Names of PCD files in the order of their sequence: observation_0000.pcd and on by
 * number, others being left out; where none is named like this, all of them by name. */
std::vector<std::string>
inSequence(std::vector<std::string> names);

/** \brief Whether a name is observation_0012.pcd or the like. */
bool
isNumbered(const std::string& name);

/** \brief Which rows of a trajectory belong to the files of a sequence: one after the
 * other where there are as many rows as files, whatever numbers the names skip; otherwise
 * the numbers in the names tell, and without any they go one after the other.
 * \param[in] trajectory path, for the message
 * \param[in] rows how many it has
 * \throws InputFileException when a file has no row */
std::vector<std::size_t>
trajectoryRows(const std::string& trajectory,
               const std::vector<std::string>& names,
               std::size_t rows);

} // namespace pcl::acmap
