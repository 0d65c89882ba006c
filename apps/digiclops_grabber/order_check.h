#pragma once

#include "status_line.h"
#include "tool.h"

#include <pcl/acquisition/digiclops_grabber.h>
#include <pcl/acquisition/pattern_projector.h>

#include <vector>

namespace pcl::acmap {

/** \brief Takes shots under patterns, in which there are corners everywhere, until the
 * grabber is certain of the order of its channels, three at most; tells it, or warns where
 * it stays uncertain.
 * \throws CameraException when a shot cannot be had
 * \throws CancelledException when the user interrupted it */
void
checkOrder(Tool& tool,
           DigiclopsGrabber& camera,
           PatternProjector& projector,
           const std::vector<RgbImage>& patterns,
           StatusLine& status);

} // namespace pcl::acmap
