#pragma once

#include "iidc_addresses.h"
#include "thrown_faults.h"
#include "usb_testbed.h"

#include <pcl/acquisition/usb_camera.h>

#include <gtest/gtest.h>

#include <chrono>
#include <functional>

namespace pcl::acmap::test {

/** \brief The image of an exposure; all images are different. */
inline std::vector<std::uint8_t>
bytesOf(std::uint64_t number, std::size_t length)
{
  std::vector<std::uint8_t> bytes(length);
  for (std::size_t i = 0; i < length; ++i)
    bytes[i] = static_cast<std::uint8_t>(i * 7 + i / 251 + number * 31);
  return bytes;
}

inline std::vector<std::uint8_t>
imageOf(const Exposure& exposure)
{
  return bytesOf(exposure.number, exposure.setting.image_bytes);
}

inline std::chrono::milliseconds
timeOf(const std::function<void()>& action)
{
  const auto begin = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::steady_clock::now() - begin);
}

/** \brief A camera on the emulated USB. */
class UsbCameraFixture : public testing::Test {
protected:
  static constexpr std::size_t frame_bytes = 640 * 480;
  static constexpr std::chrono::milliseconds patience{2000};

  std::string
  place() const
  {
    return "1:" + std::to_string(cable_.address());
  }

  /** \brief Starts the camera with grey images, 30 per second. */
  static void
  run(IidcBus& bus)
  {
    bus.writeQuadlet(iidc::commands + iidc::current_format, 0);
    bus.writeQuadlet(iidc::commands + iidc::current_mode, 5u << 29);
    bus.writeQuadlet(iidc::commands + iidc::current_rate, 4u << 29);
    bus.writeQuadlet(iidc::commands + iidc::iso_enable, iidc::on);
  }

  static void
  halt(IidcBus& bus)
  {
    bus.writeQuadlet(iidc::commands + iidc::iso_enable, 0);
  }

  static std::uint32_t
  power(IidcBus& bus)
  {
    return bus.readQuadlet(iidc::commands + iidc::power);
  }

  /** \brief A camera that loses no frames on a busy machine. */
  static CameraOptions
  patientCamera()
  {
    CameraOptions options;
    options.buffered_frames = 1000;
    return options;
  }

  EmulatedIidcCamera camera_{imageOf, patientCamera()};
  UsbTestbed testbed_;
  EmulatedUsbCamera cable_{testbed_, camera_};
};

} // namespace pcl::acmap::test
