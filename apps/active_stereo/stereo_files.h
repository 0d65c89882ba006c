#pragma once

#include "observation_maker.h"

#include <pcl/core/output_folder.h>

#include <Eigen/Geometry>

namespace pcl::acmap {

/** \brief Refuses a folder that already holds files with which results would mix.
 * \throws OutputFileException naming what it holds */
void
requireNoStereo(const OutputFolder& folder);

/** \brief Writes an observation and, if requested, its disparities as numbers and as a
 * picture.
 * \throws OutputFileException when a file could not be written completely */
void
saveResults(const OutputFolder& folder,
            const StereoOptions& options,
            const ObservationShots& shots,
            const MadeObservation& made,
            const Eigen::Isometry3d& T_map_camera);

} // namespace pcl::acmap
