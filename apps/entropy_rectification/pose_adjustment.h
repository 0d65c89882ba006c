#pragma once

#include "stage_log.h"
#include "tool.h"

#include <pcl/core/trajectory.h>
#include <pcl/mapping/entropy_rectification_types.h>
#include <pcl/pipeline/observation_sequence.h>

namespace pcl::acmap {

/** \brief Adjusts the poses of a sequence by planes, in six degrees of freedom, and
 * reports it: lines of the summary, and `adjustment` in the details.
 * \param[in] before poses before the rectification, which are adjusted first; may be empty
 * \param[in] noise of the motion from each observation to the next
 * \return the adjusted poses; those of the sequence unless they were adjusted
 * \throws InputFileException when an observation cannot be read */
Trajectory
adjustPoses(const ObservationSequence& sequence,
            const std::vector<Eigen::Isometry3d>& before,
            const OdometryNoise& noise,
            const RunControls& controls,
            StageLog& log);

} // namespace pcl::acmap
