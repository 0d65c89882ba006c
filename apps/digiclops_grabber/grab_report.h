#pragma once

#include "device.h"
#include "projection.h"

namespace pcl::acmap {

/** \brief Lines of summary and report about device and projector.
 * \param[in] projection null without
 * \param[in] frames that came */
void
tellDevice(Tool& tool,
           const GrabberOptions& options,
           const Device& device,
           const Projection* projection,
           std::size_t frames);

} // namespace pcl::acmap
