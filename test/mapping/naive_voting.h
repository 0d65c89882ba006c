#pragma once

#include "naive_entropy.h"

namespace pcl::acmap::test {

/** \brief Result of \ref naiveVoting. */
struct NaiveVoting {
  std::vector<PlanarPose> poses;
  double energy = 0;
  std::size_t votes = 0, accepted = 0;
};

/** \brief The voting of II-B.2 with plain loops, for a map whose building lies along the
 * axes; shares no code with the library but the random numbers.
 * \param[in] map with the initial poses, the first of which is that of the result */
NaiveVoting
naiveVoting(const PosedClouds& map,
            const NaiveEntropySettings& settings,
            std::uint64_t seed);

} // namespace pcl::acmap::test
