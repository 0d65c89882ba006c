#pragma once

#include "lit_scenes.h"
#include "messages.h"
#include "temporary_folder.h"

#include <pcl/acquisition/trinocular_file_grabber.h>
#include <pcl/acquisition/trinocular_recorder.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/stereo/active_stereo_grabber.h>

#include <gtest/gtest.h>

#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Three observations of a small office, each of one shot without and two with a
 * pattern, and the output of an \ref ActiveStereoGrabber for them. */
class ActiveStereoSession : public testing::Test {
protected:
  static constexpr std::size_t observations = 3;
  static constexpr std::size_t shots = 3;
  static constexpr float fast = 1000;

  ActiveStereoSession()
  {
    scene_.views.resize(observations);
  }

  shared_ptr<SimulatedRigGrabber>
  simulate(bool with_patterns = true) const
  {
    const SimulatedLight light = plainLight();
    std::vector<RgbImage> patterns;
    if (with_patterns)
      patterns = {wavePattern(light.projector), flatPattern(light.projector, 90)};
    auto frames = std::make_shared<SimulatedRigGrabber>(scene_, patterns, light);
    frames->setNumberOfThreads(1);
    return frames;
  }

  /** The same frames from files. */
  shared_ptr<TrinocularFileGrabber>
  open(float rate = fast, bool repeat = false) const
  {
    if (folder_.count() == 0)
      record();
    return std::make_shared<TrinocularFileGrabber>(session_, rate, repeat);
  }

  void
  damageFrame(std::size_t number) const
  {
    const std::string path =
        session_ + "/frame_00000" + std::to_string(number) + ".acf";
    std::string bytes = contentOf(path);
    bytes[bytes.size() - 20] = static_cast<char>(~bytes[bytes.size() - 20]);
    std::ofstream(path, std::ios::binary) << bytes;
  }

  /** \param[in] more is called for each observation after it was recorded */
  std::unique_ptr<ActiveStereoGrabber>
  grab(
      shared_ptr<TrinocularGrabber> frames, const std::function<void()>& more = [] {})
  {
    auto grabber = std::make_unique<ActiveStereoGrabber>(std::move(frames));
    setUp(grabber->fusion());
    grabber->backProjection().setNumberOfThreads(1);
    const std::function<ActiveStereoGrabber::ObservationCallback> note =
        [this, more](const ActiveStereoObservation& observation) {
          {
            const std::lock_guard lock(mutex_);
            given_.push_back(observation);
          }
          more();
        };
    grabber->registerCallback(note);
    return grabber;
  }

  /** Settings for small images; uses one thread, as the threads of grabbers are
   * tested. */
  static void
  setUp(DisparityFusion& fusion)
  {
    TrinocularMatching matching = fusion.getMatching();
    matching.setMaxDisparity(16);
    fusion.setMatching(matching);
    fusion.setNumberOfThreads(1);
  }

  std::vector<ActiveStereoObservation>
  given() const
  {
    const std::lock_guard lock(mutex_);
    return given_;
  }

  /** Numbers of the observations received; checks that each one consists of all its
   * shots. */
  std::vector<std::int32_t>
  wholeOnes() const
  {
    std::vector<std::int32_t> numbers;
    for (const ActiveStereoObservation& observation : given()) {
      EXPECT_EQ(observation.fusion.shots, shots - 1);
      EXPECT_EQ(observation.fusion.off_shots, 1u);
      numbers.push_back(observation.observation);
    }
    return numbers;
  }

  SimulatedScene scene_ = smallScene("office", 64);

private:
  void
  record() const
  {
    TrinocularRecorder recorder(session_, scene_.rig);
    for (std::size_t i = 0; i < observations; ++i)
      for (const auto& frame : simulate()->observe(i))
        recorder.record(*frame);
    recorder.finish();
  }

  TemporaryFolder folder_;
  std::string session_ = folder_.path("session");
  mutable std::mutex mutex_;
  std::vector<ActiveStereoObservation> given_;
};

} // namespace pcl::acmap::test
