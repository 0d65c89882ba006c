#pragma once

#include "lamp.h"
#include "messages.h"
#include "shutter_camera.h"

#include <pcl/acquisition/pattern_sequence_grabber.h>

#include <gtest/gtest.h>

#include <string>
#include <thread>

namespace pcl::acmap::test {

/** \brief Do all images of a frame show one level? */
bool
showsOnly(const TrinocularFrame& frame, int level);

/** \brief The level that a shot under a pattern of \ref levelPatterns should show. */
inline int
levelOf(int pattern)
{
  return 40 * (pattern + 1);
}

/** \brief A lamp, a camera that observes it, and a grabber for both, with short
 * delays. */
class SequenceRig : public testing::Test {
protected:
  using Frames = std::vector<TrinocularFrame::ConstPtr>;

  /** \brief Replaces lamp and camera. */
  void
  setLight(Milliseconds latency, Milliseconds fade = Milliseconds(0));

  /** \param[in] more called after a frame was recorded */
  std::unique_ptr<PatternSequenceGrabber>
  open(
      int patterns,
      const std::function<void(const TrinocularFrame&)>& more = [](const auto&) {});

  Frames
  frames() const;

  /** \brief The recorded frames as `observation.pattern`, separated by spaces. */
  std::string
  shots() const;

  void
  waitForFrames(std::size_t count) const;

  /** \brief Expects that the camera is idle and the projector dark. */
  void
  expectAtRest() const;

  std::shared_ptr<LightClock> light_;
  shared_ptr<Lamp> lamp_;
  shared_ptr<ShutterCamera> camera_;

  SequenceRig()
  {
    setLight(Milliseconds(0));
  }

private:
  mutable std::mutex mutex_;
  Frames frames_;
};

} // namespace pcl::acmap::test
