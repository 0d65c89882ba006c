#pragma once

#include "register_access.h"

#include <pcl/acquisition/iidc_types.h>

#include <cstddef>

namespace pcl::acmap {

/** \brief What a camera will send. */
struct StreamSetting {
  std::size_t frame_bytes = 0; ///< with what fills up the last packet
  float rate = 0;              ///< frames a second
};

/** \brief Sets a mode of a fixed format, and the rate that is nearest. */
StreamSetting
setFixedMode(const RegisterAccess& camera, const IidcMode& mode, float rate);

/** \brief Sets a mode of format 7: all of its image from the upper left corner on.
 * \param[in] rate of which the packets are just long enough; 0: as long as can be
 * \return the rate that packets of this length have at most
 * \throws CameraException Malformed when the registers make no sense, Silent when they
 * never settle */
StreamSetting
setScalableMode(const RegisterAccess& camera, const IidcMode& mode, float rate);

/** \brief Of a mode of format 7: `GBRG` and the like; empty where it does not say. */
std::string
scalableColorFilter(const RegisterAccess& camera, const IidcMode& mode);

} // namespace pcl::acmap
