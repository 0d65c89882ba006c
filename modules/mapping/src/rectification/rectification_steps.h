#pragma once

#include "entropy_search.h"

#include <pcl/mapping/impl/map_entropy_kernel.h>
#include <pcl/mapping/impl/rectification_kernel.h>

#include <vector>

namespace pcl::acmap {

/** \brief The rotation about y that aligns a building with the axes: the angle in [0,
 * pi / 2) with the minimum of H(q_X) + H(q_Z) of Eq. 3, within a twentieth of a
 * degree. */
double
buildingDirection(const std::vector<EntropyCells>& observations,
                  const std::vector<PlanarPose>& poses,
                  const MapEntropySettings& settings);

/** \brief Returns the poses in a map that is rotated about y. */
std::vector<PlanarPose>
turnedMap(const std::vector<PlanarPose>& poses, double turn);

/** \brief The paper's minimiser (II-B.2): each vote changes a random subset of the
 * actions at once, each in proportion to the effect of its previous changes on the
 * energy, and is accepted if the energy decreases. The energy is Eq. 3 of all points.
 * \return with the first pose as it was given, although a_0 is searched, too */
std::vector<PlanarPose>
votingSearch(const RectificationTask& task, const std::vector<PlanarPose>& poses);

/** \brief Descent on the direction-aware entropy with the odometry as prior, from short
 * windows to the whole map, from coarse to fine, with increasing weight of the entropy.
 * Several searches are made until the rays (\ref RayEvidence) support one of them; if
 * they support none, the poses are unchanged. */
std::vector<PlanarPose>
guardedSearch(const RectificationTask& task,
              EntropySearch& search,
              const std::vector<PlanarPose>& poses);

/** \brief Measures the sharpness of a map: its mean map entropy, and the variance of
 * the walls along the two main directions of the building. Both are computed for
 * neighbourhoods of 0.4 m in XZ. */
void
measureQuality(const std::vector<LevelledPoints>& observations,
               const std::vector<PlanarPose>& poses,
               MapEvidence& evidence);

} // namespace pcl::acmap
