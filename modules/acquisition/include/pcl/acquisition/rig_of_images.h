#pragma once

#include <pcl/acquisition/trinocular_file_grabber.h>
#include <pcl/core/calibration_file.h>
#include <pcl/core/export.h>

#include <string>
#include <vector>

namespace pcl {

/** \brief Reads the rig of lists of images from its calibration: \ref loadRig with what the
 * first image of each list tells, their size and whether they are grey. Cameras without a list
 * are not used.
 * \code
 * pcl::TrinocularImageLists images;
 * images.reference = {"right.png"};
 * images.horizontal = {"left.png"};
 * const pcl::CalibratedRig found = pcl::loadRigOfImages ({"calib.txt"}, images);
 * pcl::TrinocularFileGrabber grabber (images, found.rig);
 * \endcode
 * \param[in] paths of the calibration
 * \param[in] stated what else is known of the images
 * \throws InputFileException as \ref loadRig, and if an image cannot be read
 * \throws BadArgumentException without images of the reference, and for a list of a camera that
 * the calibration does not have \ingroup acquisition */
ACMAP_EXPORT CalibratedRig
loadRigOfImages(const std::vector<std::string>& paths,
                const TrinocularImageLists& images,
                RigImages stated = {});

} // namespace pcl
