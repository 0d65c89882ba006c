#pragma once

#include <string>

namespace pcl::acmap::bench {

/** \brief The bag under random lines, computed from real captures: bad pixels and errors by
 * method and by the number of shots. */
void
printBag();

/** \brief The same with noise added to all images. */
void
printNoise();

/** \brief A blank wall with a box before it, simulated: all that the truth can tell. */
void
printSimulated();

/** \brief Mean signed error by the fraction of the true disparity. */
void
printSubpixel();

/** \brief One shot of textured scenes, which the matching is not made for. */
void
printMiddlebury();

/** \brief A camera of a factory with a dot projector, against its own depth. */
void
printRealsense();

/** \brief CPU seconds, against those of a frame of OpenCV's. */
void
printStereoTimes();

/** \brief Writes into a folder what the paper's Fig. 2 and 3 show, of simulated shots:
 * stereo_disparities.png; and, where the data are there, the same of the bag:
 * bag_disparities.png.
 * \throws OutputFileException when it could not be written */
void
saveStereoPictures(const std::string& folder);

} // namespace pcl::acmap::bench
