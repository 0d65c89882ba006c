#pragma once

#include "iidc_addresses.h"
#include "numbered_images.h"
#include "thrown_faults.h"
#include "usb_testbed.h"

#include <pcl/acquisition/digiclops_grabber.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace pcl::acmap::test {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/** \brief Records everything that a grabber reports. */
class GrabberLog {
public:
  explicit GrabberLog(DigiclopsGrabber& grabber);

  /** \brief Waits until this number of frames has arrived; returns false on timeout. */
  bool
  awaitFrames(std::size_t count);

  bool
  awaitErrors(std::size_t count);

  std::vector<TrinocularFrame::ConstPtr>
  frames() const;

  std::vector<CameraFault>
  errors() const;

  Clock::time_point
  timeOfLastError() const;

  // Called after a frame or error was recorded; may only be set while nothing streams.
  std::function<void()> on_frame;
  std::function<void()> on_error;

private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<TrinocularFrame::ConstPtr> frames_;
  std::vector<CameraFault> errors_;
  Clock::time_point error_time_;
};

/** \brief A rig with the image size of the emulated camera.
 * \param[in] horizontal, vertical does the rig have these cameras? */
TrinocularRig
rigWith(bool horizontal, bool vertical);

/** \brief Aborts the program if a function hangs. */
void
requireEnd(const std::function<void()>& work);

/** \brief A camera that buffers many frames, so that none is lost on a busy machine. */
CameraOptions
patientCamera();

/** \brief A USB camera, and a grabber of its 30 frames per second. */
class DigiclopsTest : public testing::Test {
protected:
  explicit DigiclopsTest(const CameraOptions& options = patientCamera());

  /** \brief Opens a grabber for the rig, by default with three cameras. */
  void
  open(const TrinocularRig& rig = rigWith(true, true));

  /** \brief Starts the grabber and waits for this number of further frames. */
  void
  startFor(std::size_t frames);

  /** \brief Numbers in the source of all frames so far; compares each frame with what
   * was sent. */
  std::vector<std::uint64_t>
  sentNumbers(const Sending& sending = {}) const;

  NumberedImages images_;
  EmulatedIidcCamera emulated_;
  UsbTestbed testbed_;
  EmulatedUsbCamera cable_{testbed_, emulated_};
  std::unique_ptr<GrabberLog> log_;
  std::unique_ptr<DigiclopsGrabber> grabber_;
};

} // namespace pcl::acmap::test
