#pragma once

#include "emulated_iidc_camera.h"
#include "usb_descriptors.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::acmap::test {

/** \brief Answers a control transfer.
 *
 * Reads and writes of registers are vendor requests 0x7F: the low half of the address
 * is in wValue, the next one in wIndex, and quadlets are little-endian.
 * \param[in] message the 8 bytes of its setup, followed by its data
 * \param[in] size of the message
 * \return the bytes read, or those written; nothing: the device stalls */
std::optional<std::vector<std::uint8_t>>
answerControl(EmulatedIidcCamera& camera,
              const UsbIdentity& identity,
              const std::uint8_t* message,
              std::size_t size);

} // namespace pcl::acmap::test
