#pragma once

#include "tool.h"

#include <pcl/core/output_folder.h>
#include <pcl/pipeline/observation_sequence.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief The files of a sequence whose poses are to be estimated, in their order. */
struct ObservationList {
  ObservationSequence sequence;
  std::vector<std::string> names; ///< without their folders, in the order of the input
  std::vector<std::string> outputs; ///< output names of observations with a pose
  std::vector<double> stamps;       ///< seconds, or indices in the sequence
};

/** \brief Lists a folder, or the given files.
 *
 * Posed files keep their names; if names would be read back in another order, or are
 * given twice, they become observation_0000.pcd and so on, with a warning. Stamps are
 * those of the folder's trajectory, if it has a row for each file.
 * \param[in] inputs one folder, or files
 * \param[in] opened these files, if they are already open
 * \throws InputFileException if it is no folder, or holds no PCD file */
ObservationList
listObservations(Tool& tool,
                 const std::vector<std::string>& inputs,
                 const std::optional<ObservationSequence>& opened);

/** \brief Checks that the results would neither replace nor mix with other files.
 * \throws UsageError if an observation is in the folder
 * \throws OutputFileException if the folder holds a sequence, PCD files, pictures, a
 * report, or a map */
void
requireFit(const OutputFolder& folder, const ObservationSequence& sequence);

} // namespace pcl::acmap
