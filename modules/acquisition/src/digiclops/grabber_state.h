#pragma once

#include "camera_stream.h"
#include "images/frame_unpacking.h"
#include "rate_meter.h"

#include <pcl/acquisition/digiclops_grabber.h>
#include <pcl/core/stream_thread.h>

#include <cstdint>
#include <mutex>

namespace pcl {

/** \brief What a grabber is made of: a step of its stream gives a frame. */
struct DigiclopsGrabber::State {
  /** \brief The paper's camera works at so many frames a second. */
  static constexpr float paper_rate = 14.0F;

  State(const TrinocularRig& frame_rig, IidcBusOpener opener);

  void
  setMode(const IidcMode& new_mode, float rate);

  /** \brief The mode that suits the rig. */
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

  mutable std::mutex mutex; // of all up to the next gap; not held in callbacks
  IidcMode mode;
  float wanted_rate = paper_rate;
  float rate = 0;
  double timeout = 0.5; // seconds
  ChannelOrder order;
  bool is_order_fixed = false;
  int checks_left = most_order_checks; // of order, under calibration
  RigCalibration calibration;
  acmap::BayerPattern bayer = acmap::BayerPattern::None;
  std::uint64_t next_number = 0;
  acmap::RateMeter meter;
  DigiclopsGrabberReport report;

  acmap::CameraStream shots;  // of the stream's thread
  acmap::WholeFrame shot;     // likewise
  acmap::StreamThread stream; // the last one: it uses all others
};

} // namespace pcl
