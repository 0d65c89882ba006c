#pragma once

#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief A shot after the light was switched. */
struct LightSample {
  double delay = 0; ///< time from the switch to the shot, seconds
  double level = 0; ///< mean grey level of the pixels that are lit by the projector
};

/** \brief The shots after one switch, in order of their delays. */
using LightTurn = std::vector<LightSample>;

/** \brief How the light follows its switch. */
struct LightChange {
  double settled = 0;  ///< delay after which all changes are complete, seconds
  double dark = 0;     ///< level at the end of the last turn to dark
  double bright = 0;   ///< level at the end of the last turn to bright
  double complete = 1; ///< part of the change that counts as all of it

  /** \brief Is the change to bright, or that to dark, complete at a level? */
  bool
  isComplete(double level, bool to_bright) const
  {
    const double part = (level - dark) / (bright - dark);
    return (to_bright ? part : 1 - part) >= complete;
  }
};

/** \brief Finds the delay after which all changes are complete.
 * \param[in] turns alternately to dark and to bright; at least two, none empty
 * \param[in] tail delay after which a change is assumed to be complete, seconds
 * \return nothing if the levels do not follow the turns, or not before the last shot */
std::optional<LightChange>
findLightChange(const std::vector<LightTurn>& turns, double tail);

} // namespace pcl::acmap
