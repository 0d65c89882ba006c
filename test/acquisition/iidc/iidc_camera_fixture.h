#pragma once

#include "iidc_addresses.h"
#include "memory_bus.h"
#include "thrown_faults.h"

#include <pcl/acquisition/iidc_camera.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pcl::acmap::test {

/** \brief A source of constant grey images. */
inline std::vector<std::uint8_t>
greyImage(const Exposure& exposure)
{
  return std::vector<std::uint8_t>(exposure.setting.image_bytes, 0x55);
}

/** \brief A camera on a bus in memory. */
class IidcCameraTest : public testing::Test {
protected:
  explicit IidcCameraTest(const CameraOptions& options = {})
  : emulated_(greyImage, options)
  {}

  /** \brief Value of a command register of the emulated camera. */
  std::uint32_t
  registerAt(std::uint32_t offset)
  {
    return emulated_.read(iidc::commands + offset).value();
  }

  IidcMode
  modeOf(int format, IidcColor color)
  {
    for (const IidcMode& mode : camera_.modes())
      if (mode.format == format && mode.color == color)
        return mode;
    throw std::logic_error("the emulated camera lacks a mode");
  }

  EmulatedIidcCamera emulated_;
  MemoryCable cable_{emulated_};
  IidcCamera camera_{cable_.opener()};
};

} // namespace pcl::acmap::test
