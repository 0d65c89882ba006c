#pragma once

#include "map_run.h"

#include <pcl/pipeline/map_comparison.h>

namespace pcl::acmap {

/** \brief Writes the reports of all stages into summary, warnings and report.
 * \param[in] figures of the comparison with the truth, if it is known */
void
tellChain(const ChainOptions& options,
          StartingPoint start,
          const std::vector<RunStage>& stages,
          const std::optional<MapFigures>& figures,
          StageLog& log);

} // namespace pcl::acmap
