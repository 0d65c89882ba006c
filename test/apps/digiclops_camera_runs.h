#pragma once

#include "digiclops_runs.h"
#include "filmed_by_camera.h"
#include "temporary_folder.h"
#include "usb_testbed.h"
#include "virtual_display.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief The corner of a room, a projector on a virtual screen, and an emulated camera
 * on the USB that looks at the corner, which is filmed once. */
class DigiclopsCameraRuns : public testing::Test {
protected:
  static constexpr int patterns = 4;
  static constexpr int screen_width = 512;
  static constexpr int screen_height = 384;

  static void
  SetUpTestSuite();

  static void
  TearDownTestSuite();

  /** \brief The session that a camera synchronised with the projector records. */
  static std::string
  truth()
  {
    return folders_->path("truth");
  }

  /** \brief Result of pcl_active_stereo for it. */
  static std::string
  trueClouds()
  {
    return folders_->path("clouds");
  }

  static CameraOptions
  usualCamera();

  void
  SetUp() override;

  /** \brief Grabs clouds and a session with few patterns.
   * \param[in] more options */
  ToolRun
  grab(const std::vector<std::string>& more = {},
       const RunSettings& settings = {}) const;

  static TemporaryFolder* folders_;
  static VirtualDisplay* display_;
  static std::string screen_; ///< name of the display
  static SimulatedScene* scene_;
  static std::vector<RgbImage> lights_;
  static FilmedByCamera* film_;

  TemporaryFolder folder_;
  std::string clouds_ = folder_.path("clouds");
  std::string recorded_ = folder_.path("recorded");
  ProjectorWatch projector_{lights_};
  EmulatedIidcCamera camera_{[](const Exposure& e) { return film_->expose(e); },
                             usualCamera()};
  UsbTestbed testbed_;
  EmulatedUsbCamera cable_{testbed_, camera_};
};

} // namespace pcl::acmap::test
