#pragma once

#include "truth_comparison.h"

namespace pcl::acmap {

/** \brief Warns where the motions were found on the floor, and the camera left it. */
void
warnOfFreeMotion(Tool& tool, const VisualOdometryResult& run);

/** \brief Tells on stdout and in the report what became of a sequence; lost observations
 * are warned of by name.
 * \param[in] comparison nothing where the truth is not known */
void
tellRun(Tool& tool,
        const EgomotionOptions& options,
        const ObservationList& list,
        const VisualOdometryResult& run,
        const std::optional<TruthComparison>& comparison);

} // namespace pcl::acmap
