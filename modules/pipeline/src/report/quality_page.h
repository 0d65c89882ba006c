#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace pcl::acmap {

/** \brief The four figures of a map for its page: a list of objects with "name", "value", "advice",
 * "meaning", and "scale", a drawing (SVG) of where the value lies between bad and good.
 * \param[in] quality of a report; anything else gives an empty list */
nlohmann::ordered_json
figuresOf(const nlohmann::ordered_json& quality);

/** \brief Draws a map from above: walls in colours of their roughness, what was not seen hatched, and the
 * next positions as numbered arrows.
 * \param[in] plan of a report
 * \param[in] roughness of the planes, metres
 * \param[in] positions list of the next positions
 * \return SVG; empty if the plan has no room and no wall */
std::string
placeDrawing(const nlohmann::ordered_json& plan,
             const nlohmann::ordered_json& roughness,
             const nlohmann::ordered_json& positions);

/** \brief Draws the energy of a search over its steps, each above the lowest of its kind.
 * \param[in] steps "search", bin_size and "energy" of a report, lists of the same length
 * \return SVG; empty without steps */
std::string
energyDrawing(const nlohmann::ordered_json& steps);

} // namespace pcl::acmap
