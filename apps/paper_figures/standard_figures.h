#pragma once

namespace pcl::acmap {

/** \brief The text of share/paper_figures.yaml. */
const char*
standardFiguresText();

} // namespace pcl::acmap
