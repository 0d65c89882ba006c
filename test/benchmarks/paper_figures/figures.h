#pragma once

#include "stage_log.h"

#include <string>

namespace pcl::acmap {

/** \brief Options of the user. */
struct FigureOptions {
  std::string session;    ///< that pcl_simulated_rig filmed
  std::string map;        ///< folder that pcl_compact_mapping made of it
  std::string papers_map; ///< that it made of it in the paper's way; empty: none
  std::string output;
  std::string figures; ///< what they show; empty: paper_figures.yaml
};

/** \brief Draws the figures of the paper and writes the page that shows them: the
 * complete work of acmap_paper_figures.
 * \throws according to the exit codes of its documentation page */
void
drawFigures(const FigureOptions& options, const RunControls& controls, StageLog& log);

} // namespace pcl::acmap
