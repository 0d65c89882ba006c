#pragma once

#include "iidc_addresses.h"
#include "numbered_images.h"
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

/** \brief All that a grabber tells. */
class GrabberLog {
public:
  explicit GrabberLog(DigiclopsGrabber& grabber);

  /** \brief Whether so many frames have come, or come in time. */
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

  // Called after they are noted; set while nothing streams.
  std::function<void()> on_frame;
  std::function<void()> on_error;

private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<TrinocularFrame::ConstPtr> frames_;
  std::vector<CameraFault> errors_;
  Clock::time_point error_time_;
};

/** \brief A rig of the emulated camera's size.
 * \param[in] horizontal, vertical whether there are such cameras */
TrinocularRig
rigWith(bool horizontal, bool vertical);

/** \brief What a piece of work throws of a camera; None when it throws nothing. */
CameraFault
faultOf(const std::function<void()>& work);

/** \brief Ends the program when a piece of work hangs. */
void
requireEnd(const std::function<void()>& work);

/** \brief A camera that keeps frames for whoever is late, so that none is lost on a machine
 * that has more to do. */
CameraOptions
patientCamera();

/** \brief A camera on the USB, and a grabber of its frames, 30 a second. */
class DigiclopsTest : public testing::Test {
protected:
  explicit DigiclopsTest(const CameraOptions& options = patientCamera());

  /** \brief Opens a grabber of three cameras. */
  void
  open(const TrinocularRig& rig = rigWith(true, true));

  /** \brief Starts, and waits for so many frames more. */
  void
  startFor(std::size_t frames);

  /** \brief Frames so far, each compared with what was sent, as numbers of the source. */
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
