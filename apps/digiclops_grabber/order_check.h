#pragma once

#include "status_line.h"
#include "tool.h"

#include <pcl/acquisition/digiclops_grabber.h>
#include <pcl/acquisition/pattern_projector.h>

#include <vector>

namespace pcl::acmap {

/** \brief Takes up to three shots under patterns, which provide corners everywhere,
 * until the grabber is certain of the order of its channels. Reports the order, or
 * warns if it remains uncertain.
 * \throws CameraException when a shot fails
 * \throws CancelledException when the user interrupted it */
void
checkOrder(Tool& tool,
           DigiclopsGrabber& camera,
           PatternProjector& projector,
           const std::vector<RgbImage>& patterns,
           StatusLine& status);

} // namespace pcl::acmap
