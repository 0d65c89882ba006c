#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace pcl::acmap {

/** \brief The energy over the steps of the rectification as SVG, with a legend, in the
 * style of \ref energyPicture; empty if there are no steps.
 * \param[in] steps columns "search", "bin_size" and "energy" */
std::string
energyFigure(const nlohmann::ordered_json& steps);

} // namespace pcl::acmap
