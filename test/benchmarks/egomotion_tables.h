#pragma once

#include <string>

namespace pcl::acmap::bench {

/** \brief Simulated drives through corridors, with walls of different grain, using the
 * stereo matching of acmap. */
void
printEgomotionSimulated();

/** \brief A hand-held Kinect: neighbouring views, and views further apart. */
void
printEgomotionKitchen();

/** \brief Do the errors agree with the covariances (NEES)? */
void
printEgomotionCovariance();

/** \brief Replaces matches by wrong ones before the rejection, and measures the effect
 * on the action. */
void
printEgomotionOutliers();

/** \brief CPU time per pair, by stage. */
void
printEgomotionTimes();

/** \brief Drives through corridors: the trajectory of egomotion, and the same
 * rectified. */
void
printEgomotionRectification();

/** \brief Mixes wrong matches with correct ones: which are kept, and what motion they
 * give. */
void
printEgomotionRejection();

/** \brief Writes pictures of matches before and after rejection, and of the trajectory.
 * \throws OutputFileException when they could not be written */
void
saveEgomotionPictures(const std::string& folder);

} // namespace pcl::acmap::bench
