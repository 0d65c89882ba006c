#pragma once

#include <string>

namespace pcl::acmap::bench {

/** \brief The bag under random lines, computed from real captures: bad pixels and
 * errors by method and number of shots. */
void
printBag();

/** \brief As above with noise added to all images. */
void
printNoise();

/** \brief A simulated blank wall with a box in front of it: all statistics that need
 * the truth. */
void
printSimulated();

/** \brief Mean signed error by the fractional part of the true disparity. */
void
printSubpixel();

/** \brief One shot of textured scenes, for which the matching is not designed. */
void
printMiddlebury();

/** \brief A commercial camera with a dot projector, compared with its own depth. */
void
printRealsense();

/** \brief How many patterns an observation needs: random ones, and selected ones. */
void
printPatternNumbers();

/** \brief CPU seconds, compared with those of OpenCV for one frame. */
void
printStereoTimes();

/** \brief Writes pictures as in the paper's Fig. 2 and 3 into a folder: from simulated
 * shots stereo_disparities.png; and, if the data exist, from the bag
 * bag_disparities.png.
 * \throws OutputFileException when a file could not be written */
void
saveStereoPictures(const std::string& folder);

} // namespace pcl::acmap::bench
