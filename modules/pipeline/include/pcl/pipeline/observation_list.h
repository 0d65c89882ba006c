#pragma once

#include <pcl/core/export.h>
#include <pcl/pipeline/observation_sequence.h>

#include <string>

namespace pcl {

/** \brief The list of the observations, relative to the folder of a map. */
inline constexpr const char* observation_list_name = "stages/observations.txt";

/** \brief Writes which files the observations of a map are, one path per line in the order
 * of its trajectory, so that a later session can extend the map.
 * \param[in] path of the list
 * \param[in] map folder of the map; files in it are named relative to it, others by
 * absolute paths
 * \throws OutputFileException if it could not be written completely \ingroup pipeline */
ACMAP_EXPORT void
saveObservationList(const std::string& path,
                    const std::string& map,
                    const ObservationSequence& sequence);

/** \brief Opens the observations of a map with their poses in it, and its shift.
 * \param[in] map folder with its list of observations and its trajectory.txt
 * \throws InputFileException if one of both is missing or malformed, they differ in
 * number, or an observation is missing \ingroup pipeline */
ACMAP_EXPORT ObservationSequence
openMappedObservations(const std::string& map);

} // namespace pcl
