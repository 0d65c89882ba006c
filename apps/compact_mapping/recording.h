#pragma once

#include "stage_log.h"

#include <pcl/pipeline/observation_sequence.h>

#include <cstddef>
#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief Opens a file that has several observations: an E57 file of several scans, or a bag
 * of ROS 2. Nothing for another file or a folder.
 * \param[in] every take each n-th observation of a bag
 * \throws InputFileException when it cannot be read */
std::optional<ObservationSequence>
openRecording(const std::string& path, std::size_t every);

/** \brief Writes the observations of such a file as a folder of PCDs, with trajectory.txt if
 * their poses are known, as a step of the chain. The detail `shift` is that of the
 * sequence.
 * \param[in] path of the file
 * \throws InputFileException when an observation cannot be read */
void
importRecording(const std::string& path,
                ObservationSequence sequence,
                const std::string& folder,
                const RunControls& controls,
                StageLog& log);

} // namespace pcl::acmap
