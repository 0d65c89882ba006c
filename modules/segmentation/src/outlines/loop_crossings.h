#pragma once

#include "outlines/loop.h"

namespace pcl::acmap::outlines {

/** Loops of a surface on their left, such that none crosses itself or another: those that
 * do are cut where they meet, and drawn anew round what they wind round. What they share is
 * then whole corners. Loops that keep their distance stay as they are.
 * \param[in] distance below which points meet, metres; well above rounding to floats.
 * Where doubles round to more it is that */
std::vector<Loop>
disentangled(const std::vector<Loop>& loops, double distance);

} // namespace pcl::acmap::outlines
