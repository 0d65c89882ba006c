#pragma once

#include "camera_stream.h"
#include "images/frame_unpacking.h"
#include "rate_meter.h"

#include <pcl/acquisition/digiclops_grabber.h>
#include <pcl/core/stream_thread.h>

#include <cstdint>
#include <mutex>

namespace pcl {

/** \brief Implementation of the grabber; one step of its stream gives one frame. */
struct DigiclopsGrabber::State {
  /** \brief Frame rate of the paper's camera, in Hz. */
  static constexpr float paper_rate = 14.0F;

  State(const TrinocularRig& frame_rig, IidcBusOpener opener);

  void
  setMode(const IidcMode& new_mode, float rate);

  /** \brief Finds the mode that matches the rig. */
  IidcMode
  findMode() const;

  void
  requireIdle() const;

  bool
  give();

  TrinocularFrame::Ptr
  unpack(acmap::WholeFrame& shot);

  void
  checkOrder(const IidcFrame& raw, TrinocularFrame& frame);

  void
  end();

  const TrinocularRig rig;
  IidcCamera camera;
  boost::signals2::signal<FrameCallback>* frames = nullptr;
  boost::signals2::signal<ErrorCallback>* errors = nullptr;

  // Protects the members up to the next empty line; not held in callbacks.
  mutable std::mutex mutex;
  IidcMode mode;
  float wanted_rate = paper_rate;
  float rate = 0;
  double timeout = 0.5; // seconds
  ChannelOrder order;
  bool is_order_fixed = false;
  int checks_left = max_order_checks; // remaining checks of order with calibration
  RigCalibration calibration;
  acmap::BayerPattern bayer = acmap::BayerPattern::None;
  std::uint64_t next_number = 0;
  acmap::RateMeter meter;
  DigiclopsGrabberReport report;

  acmap::CameraStream shots;  // used by the stream's thread only
  acmap::WholeFrame shot;     // used by the stream's thread only
  acmap::StreamThread stream; // declared last, since its thread uses all other members
};

} // namespace pcl
