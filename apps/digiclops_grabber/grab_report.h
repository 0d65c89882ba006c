#pragma once

#include "device.h"
#include "projection.h"

namespace pcl::acmap {

/** \brief Writes lines of summary and report about device and projector.
 * \param[in] projection null if there is none
 * \param[in] frames number of received frames */
void
tellDevice(Tool& tool,
           const GrabberOptions& options,
           const Device& device,
           const Projection* projection,
           std::size_t frames);

} // namespace pcl::acmap
