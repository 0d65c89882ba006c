#include "lit_scenes.h"
#include "sequence_rig.h"

#include <pcl/simulation/simulated_rig_grabber.h>

namespace pcl::acmap::test {
namespace {

/** A projector that stores the current pattern. */
class SimulatedProjection : public PatternProjector {
public:
  void
  show(const RgbImage& image) override
  {
    image_ = image;
  }

  void
  showNothing() override
  {
    image_ = {};
  }

  const RgbImage&
  image() const
  {
    return image_;
  }

private:
  RgbImage image_; // does not change during a shot
};

/** Returns the simulated view under the current pattern of the projector. It does not
 * know frame numbers, and of observations only their poses. */
class SimulatedCamera : public TrinocularGrabber {
public:
  SimulatedCamera(const SimulatedRigGrabber& rig,
                  const SimulatedProjection& projection,
                  const std::vector<RgbImage>& patterns)
  : rig_(rig)
  , projection_(projection)
  , patterns_(patterns)
  , signal_(createSignal<FrameCallback>())
  , stream_([this] { return giveShot(); }, {})
  {}

  ~SimulatedCamera() noexcept override
  {
    stream_.stop();
  }

  std::atomic<std::size_t> place{0};

  void
  start() override
  {
    stream_.add(StreamThread::endless);
  }

  void
  stop() override
  {
    stream_.stop();
  }

  void
  trigger() override
  {
    stream_.add(1);
  }

  void
  rewind() override
  {}

  void
  wait() override
  {
    stream_.wait();
  }

  bool
  isRunning() const override
  {
    return stream_.isRunning();
  }

  std::string
  getName() const override
  {
    return "SimulatedCamera";
  }

  float
  getFramesPerSecond() const override
  {
    return 0;
  }

  TrinocularRig
  getRig() const override
  {
    return rig_.getRig();
  }

  std::exception_ptr
  getError() const override
  {
    return stream_.error();
  }

private:
  bool
  giveShot()
  {
    std::size_t shot = 0;
    for (std::size_t i = 0; i < patterns_.size(); ++i)
      if (patterns_[i].values == projection_.image().values)
        shot = 1 + i;
    const TrinocularFrame::Ptr frame = rig_.observe(place).at(shot);
    frame->number = 0;
    frame->observation = 0;
    frame->pattern = 0;
    (*signal_)(frame);
    return true;
  }

  const SimulatedRigGrabber& rig_;
  const SimulatedProjection& projection_;
  const std::vector<RgbImage>& patterns_;
  boost::signals2::signal<FrameCallback>* const signal_;
  StreamThread stream_; // last member, because it uses all others
};

TEST(SequenceOverASimulation, GivesTheSimulatorsOwnFrames)
{
  SimulatedScene scene = smallScene("office", 64);
  scene.views.resize(2);
  SimulatedLight light = plainLight();
  light.read_noise = 2.0;
  const std::vector<RgbImage> patterns{wavePattern(light.projector),
                                       flatPattern(light.projector, 90)};
  const SimulatedRigGrabber rig(scene, patterns, light);
  const auto projection = pcl::make_shared<SimulatedProjection>();
  const auto camera = pcl::make_shared<SimulatedCamera>(rig, *projection, patterns);
  PatternSequenceGrabber grabber(camera, projection, patterns);
  grabber.setSettleTime(0);
  std::vector<TrinocularFrame::ConstPtr> frames;
  const std::function<TrinocularGrabber::FrameCallback> note =
      [&](const TrinocularFrame::ConstPtr& frame) { frames.push_back(frame); };
  grabber.registerCallback(note);
  for (std::size_t place = 0; place < 2; ++place) {
    camera->place = place;
    grabber.observe();
    grabber.wait();
    EXPECT_EQ(errorOf(grabber), "");
  }
  ASSERT_EQ(frames.size(), 6U);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const TrinocularFrame wanted = *rig.observe(i / 3).at(i % 3);
    EXPECT_EQ(frames[i]->number, wanted.number);
    EXPECT_EQ(frames[i]->observation, wanted.observation);
    EXPECT_EQ(frames[i]->pattern, wanted.pattern);
    EXPECT_EQ(frames[i]->stamp, wanted.stamp);
    EXPECT_EQ(frames[i]->images, wanted.images);
  }
}

} // namespace
} // namespace pcl::acmap::test
