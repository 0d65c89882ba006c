#pragma once

#include <pcl/acquisition/camera_exception.h>

#include <string>

namespace pcl::acmap {

/** \brief Throws the CameraException that corresponds to an error of libusb.
 * \param[in] error code of libusb
 * \param[in] place location of the camera, for the message
 * \param[in] doing action that failed, for the message */
[[noreturn]] void
failUsb(int error, const std::string& place, const std::string& doing);

/** \brief Throws when a function of libusb returned an error, which is a negative
 * number. */
void
checkUsb(int result, const std::string& place, const std::string& doing);

} // namespace pcl::acmap
