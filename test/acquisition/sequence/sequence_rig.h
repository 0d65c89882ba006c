#pragma once

#include "lamp.h"
#include "shutter_camera.h"

#include <pcl/acquisition/pattern_sequence_grabber.h>

#include <gtest/gtest.h>

#include <string>
#include <thread>

namespace pcl::acmap::test {

/** \brief Message of what ended the stream; empty where nothing did. */
std::string
errorOf(const TrinocularGrabber& grabber);

/** \brief Whether all of a frame shows one level. */
bool
showsOnly(const TrinocularFrame& frame, int level);

/** \brief What a shot under a pattern of \ref levelPatterns should show. */
inline int
levelOf(int pattern)
{
  return 40 * (pattern + 1);
}

/** \brief A lamp, a camera that sees it, and a grabber over both, quick ones. */
class SequenceRig : public testing::Test {
protected:
  using Frames = std::vector<TrinocularFrame::ConstPtr>;

  /** \brief Takes another lamp; both are new then. */
  void
  setLight(Milliseconds latency, Milliseconds fade = Milliseconds(0));

  /** \param[in] more after the frame was noted */
  std::unique_ptr<PatternSequenceGrabber>
  open(
      int patterns,
      const std::function<void(const TrinocularFrame&)>& more = [](const auto&) {});

  Frames
  frames() const;

  /** \brief Of frames given: `observation.pattern` each, parted by blanks. */
  std::string
  shots() const;

  void
  waitForFrames(std::size_t count) const;

  /** \brief Camera at rest, projector dark. */
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
