#pragma once

#include "observation_maker.h"

#include <pcl/core/output_folder.h>

#include <Eigen/Geometry>

namespace pcl::acmap {

/** \brief Refuses a folder that results would mix with.
 * \throws OutputFileException naming what it holds */
void
requireNoStereo(const OutputFolder& folder);

/** \brief Writes an observation, and its disparities where they are wanted, as numbers and
 * as a picture.
 * \throws OutputFileException when a file could not be written whole */
void
saveResults(const OutputFolder& folder,
            const StereoOptions& options,
            const ObservationShots& shots,
            const MadeObservation& made,
            const Eigen::Isometry3d& T_map_camera);

} // namespace pcl::acmap
