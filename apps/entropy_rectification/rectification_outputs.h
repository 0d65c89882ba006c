#pragma once

#include "map_observations.h"
#include "rectification_options.h"

#include <pcl/core/output_folder.h>

#include <vector>

namespace pcl::acmap {

/** \brief Writes the results: trajectory.txt, trajectory_before.txt, map.pcd,
 * plan_before.png, plan_after.png, plan.png, energy.png and, if requested, the
 * observations.
 * \param[in] poses rectified, T_map_camera
 * \param[in] floor its normal, y > 0: plans are drawn along it
 * \param[in] steps of the search
 * \throws OutputFileException when one could not be written
 * \throws InputFileException when an observation can no longer be read
 * \throws MemoryRefused when this machine has not enough memory for the map */
void
writeOutputs(Tool& tool,
             const RectificationOptions& options,
             const MapObservations& observations,
             const std::vector<Eigen::Isometry3d>& poses,
             const Eigen::Vector3d& floor,
             const std::vector<RectificationStep>& steps,
             const OutputFolder& folder);

} // namespace pcl::acmap
