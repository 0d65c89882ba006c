#pragma once

#include "chain.h"
#include "truth_report.h"

namespace pcl::acmap {

/** \brief Inputs and options of the map, for \ref Chain::run. */
nlohmann::ordered_json
mapIsMadeOf(Tool& tool,
            const ChainOptions& options,
            const Sequence& sequence,
            bool has_pictures);

/** \brief Writes the reports of all stages into summary, warnings and report, and draws
 * report.html.
 * \param[in] figures of the comparison with the truth, if it is known
 * \throws OutputFileException when that cannot be written */
void
tellChain(Tool& tool,
          const ChainOptions& options,
          StartingPoint start,
          const std::vector<RunStage>& stages,
          const std::optional<MapFigures>& figures);

} // namespace pcl::acmap
