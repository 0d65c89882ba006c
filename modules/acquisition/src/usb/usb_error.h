#pragma once

#include <pcl/acquisition/camera_exception.h>

#include <string>

namespace pcl::acmap {

/** \brief Throws what an error of libusb's means for a camera.
 * \param[in] doing what failed, for the message */
[[noreturn]] void
failUsb(int error, const std::string& place, const std::string& doing);

/** \brief Throws when a function of libusb's gave an error: a number below 0. */
void
checkUsb(int result, const std::string& place, const std::string& doing);

} // namespace pcl::acmap
