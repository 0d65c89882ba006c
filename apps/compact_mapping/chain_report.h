#pragma once

#include "chain.h"
#include "truth_report.h"

namespace pcl::acmap {

/** \brief Inputs and options of the map, for \ref Chain::run.
 * \param[in] values of the options of the map that the user set */
nlohmann::ordered_json
mapIsMadeOf(const ChainOptions& options,
            const Sequence& sequence,
            nlohmann::ordered_json values,
            double scale,
            bool has_pictures);

/** \brief Writes the reports of all stages into summary, warnings and report.
 * \param[in] figures of the comparison with the truth, if it is known */
void
tellChain(const ChainOptions& options,
          StartingPoint start,
          const std::vector<RunStage>& stages,
          const std::optional<MapFigures>& figures,
          StageLog& log);

} // namespace pcl::acmap
