#pragma once

#include <pcl/pipeline/observation_sequence.h>

#include <optional>

namespace pcl::acmap::bench {

/** \brief Sixty scans of a laser that was carried through a building, with the poses of its
 * authors' odometry, metres; nothing, with a message on stderr, if they are missing. */
std::optional<ObservationSequence>
loadLaserScans();

} // namespace pcl::acmap::bench
