#pragma once

#include "register_access.h"

#include <pcl/acquisition/iidc_types.h>

#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief The format whose modes have variable image and packet sizes. */
constexpr int scalable_format = 7;

/** \brief Lists the modes that a camera reports and whose registers are valid, in
 * ascending order. A mode of format 7 is listed once per colour coding. */
std::vector<IidcMode>
listModes(const RegisterAccess& camera);

/** \brief Frames per second of a rate number of the registers, 0 to 7. */
float
fixedRate(unsigned number);

/** \brief Properties of a camera's stream. */
struct StreamSetting {
  std::size_t frame_bytes = 0; ///< including the padding of the last packet
  float rate = 0;              ///< frames per second
};

/** \brief Sets a mode of a fixed format with the nearest rate. */
StreamSetting
setFixedMode(const RegisterAccess& camera, const IidcMode& mode, float rate);

/** \brief Sets a mode of format 7 with its full image, beginning at the upper left
 * corner.
 * \param[in] rate determines the packet size, which is the smallest one that reaches
 * it; 0: largest packet size
 * \return the maximum rate for this packet size
 * \throws CameraException Malformed when the registers contain invalid values, Silent
 * when the camera does not process them */
StreamSetting
setScalableMode(const RegisterAccess& camera, const IidcMode& mode, float rate);

/** \brief Colour filter of a mode of format 7: `GBRG` or similar; empty if it is not
 * reported. */
std::string
scalableColorFilter(const RegisterAccess& camera, const IidcMode& mode);

} // namespace pcl::acmap
