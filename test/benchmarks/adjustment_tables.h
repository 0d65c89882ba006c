#pragma once

#include <cstdint>

namespace pcl::acmap::bench {

/** \brief Seeds of the drift: judged are 11 to 20, tuned was with 1 to 6. */
struct DriftSeeds {
  std::uint64_t first = 11, last = 20;
};

/** \brief Simulated scenes with drift in six degrees of freedom, once, four and eight
 * times the usual one. */
void
printAdjustedScenes(const DriftSeeds& seeds);

/** \brief Four and eight times the usual drift, straightened by entropy first. */
void
printRectifiedScenes(const DriftSeeds& seeds);

/** \brief PCL's LUM, ELCH and a chain of generalized ICP on the same runs. */
void
printAdjustmentPeers(const DriftSeeds& seeds);

/** \brief Odometry whose errors are not those that were told. */
void
printWrongOdometry(const DriftSeeds& seeds);

/** \brief Poses that are right already. */
void
printRightPoses();

/** \brief The length of a corridor without any feature. */
void
printBlankCorridor(const DriftSeeds& seeds);

/** \brief Recall and precision of revisits, and what they add to the adjustment. */
void
printRevisits(const DriftSeeds& seeds);

/** \brief A hand-held depth camera, with its own egomotion. */
void
printAdjustedKitchen();

/** \brief A carried laser scanner: scans that the adjustment did not see. */
void
printAdjustedScans();

/** \brief Time for 106 and 1,000 views. */
void
printAdjustmentSize();

} // namespace pcl::acmap::bench
