#pragma once

#include "truth_comparison.h"

namespace pcl::acmap {

/** \brief Warns if the motion model was planar, but the camera left the floor. */
void
warnOfFreeMotion(Tool& tool, const VisualOdometryResult& run);

/** \brief Reports the result for a sequence on stdout and in the report, and warns of
 * lost observations by name.
 * \param[in] comparison nothing if the truth is not known */
void
tellRun(Tool& tool,
        const EgomotionOptions& options,
        const ObservationList& list,
        const VisualOdometryResult& run,
        const std::optional<TruthComparison>& comparison);

} // namespace pcl::acmap
