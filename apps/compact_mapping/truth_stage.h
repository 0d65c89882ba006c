#pragma once

#include "chain.h"

#include <pcl/pipeline/map_comparison.h>

namespace pcl::acmap {

/** \brief Compares the finished map of a sequence with the ground truth of its session.
 * \param[in] sequence with poses
 * \throws InputFileException when an observation has no true pose, or a result of the
 * chain cannot be read */
MapFigures
compareMap(const ChainOptions& options,
           const Chain& chain,
           const Sequence& sequence,
           const SessionTruth& truth);

} // namespace pcl::acmap
