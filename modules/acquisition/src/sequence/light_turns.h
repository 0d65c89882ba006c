#pragma once

#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief A shot after the light was told to change. */
struct LightSample {
  double delay = 0; ///< from there to the shot, seconds
  double level = 0; ///< mean grey level where the light falls
};

/** \brief The shots after one change, by their delays. */
using LightTurn = std::vector<LightSample>;

/** \brief The delay behind which all changes have come to their end.
 * \param[in] turns to dark, to bright, to dark and so on; at least two, none empty
 * \param[in] tail delay from which a change is taken to be at its end, seconds
 * \return nothing where the levels do not follow the turns, or not before the last shot
 */
std::optional<double>
findSettleTime(const std::vector<LightTurn>& turns, double tail);

} // namespace pcl::acmap
