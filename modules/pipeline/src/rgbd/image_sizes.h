#pragma once

#include <pcl/pipeline/rgbd_sequence.h>

namespace pcl::acmap {

/** \brief Have two images one size? */
bool
areSame(const ImageSize& a, const ImageSize& b);

/** \brief Is an image larger than another one of the same shape, within 1 %? */
bool
isEnlarged(const ImageSize& large, const ImageSize& small);

/** \brief A camera for images of another size. */
Pinhole
scaledPinhole(const Pinhole& camera, const ImageSize& from, const ImageSize& to);

/** \brief Reads a frame's images for their sizes, that of the first frame which is whole, and
 * fits the cameras of the folder to them: one that is stated for another size is scaled, also
 * one that is evidently that of the colour images. Each such step is a remark.
 * \param[in] has_camera the caller states the depth camera */
void
fitCameras(bool has_camera, RgbdSequence& sequence);

} // namespace pcl::acmap
