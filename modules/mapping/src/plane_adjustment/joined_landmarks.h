#pragma once

#include "plane_landmarks.h"

#include <vector>

namespace pcl::acmap {

/** \brief Joins landmarks that continue each other on one plane within their noise, up to
 * some metres from the most informative one: a floor or a wall determines a tilt by its
 * length, its parts of a metre hardly do, and errors of tilts add up along a corridor.
 *
 * A landmark is joined if that raises chi^2 by no more than noise does. What is bent or
 * stepped by more stays apart, as do the landmarks that nothing continues. */
std::vector<Landmark>
joinLandmarks(const std::vector<Landmark>& landmarks, const Poses& poses);

} // namespace pcl::acmap
