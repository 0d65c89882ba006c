#pragma once

#include <string>

namespace pcl::acmap::bench {

/** \brief Drives through simulated corridors, with walls of more and less grain, through
 * our own stereo. */
void
printEgomotionSimulated();

/** \brief A hand-held Kinect: neighbours, and views further apart. */
void
printEgomotionKitchen();

/** \brief Matches replaced by wrong ones before the worst are left out: what becomes of
 * the action. */
void
printEgomotionOutliers();

/** \brief CPU of one pair, by stage. */
void
printEgomotionTimes();

/** \brief Driven corridors: the path of egomotion, and the same rectified. */
void
printEgomotionRectification();

/** \brief Wrong matches among right ones: which are kept, and what motion they give. */
void
printEgomotionRejection();

/** \brief Writes pictures of matches before and after rejection, and of the path.
 * \throws OutputFileException when they could not be written */
void
saveEgomotionPictures(const std::string& folder);

} // namespace pcl::acmap::bench
