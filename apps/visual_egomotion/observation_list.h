#pragma once

#include "tool.h"

#include <pcl/core/output_folder.h>

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief The files of a sequence, in their order. */
struct ObservationList {
  std::vector<std::string> paths;
  std::vector<std::string> names;   ///< without their folders, as they came
  std::vector<std::string> outputs; ///< names for the posed ones
  std::vector<double> stamps;       ///< seconds, or places in the sequence

  std::size_t
  size() const
  {
    return paths.size();
  }
};

/** \brief Lists a folder, or takes the files that are named.
 *
 * Posed files keep their names; where names would be read back in another order, or are
 * given twice, they become observation_0000.pcd and on, with a warning. Stamps are those of
 * the folder's trajectory, where it has a row for each file.
 * \param[in] inputs one folder, or files
 * \throws InputFileException when the folder is none, or holds no PCD */
ObservationList
listObservations(Tool& tool, const std::vector<std::string>& inputs);

/** \brief Checks that the results would neither replace nor mix with other files.
 * \throws UsageError when an observation lies in the folder
 * \throws OutputFileException when the folder holds a sequence, PCDs, pictures, a
 * report, or a map */
void
requireFit(const OutputFolder& folder, const ObservationList& list);

} // namespace pcl::acmap
