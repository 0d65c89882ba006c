#include <pcl/core/exceptions.h>
#include <pcl/simulation/simulated_rig_grabber.h>

#include "light/rig_simulation.h"

#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/parallel.h>

#include <atomic>
#include <mutex>
#include <optional>
#include <utility>

namespace pcl {

namespace {

std::unique_ptr<const acmap::RigSimulation>
simulationOf(const SimulatedScene& scene,
             const std::vector<RgbImage>& patterns,
             const SimulatedLight& light,
             acmap::RigRays cameras)
{
  if (scene.views.empty())
    throw acmap::BadArgument("scene '" + scene.name + "' has no views to see it from");
  return std::make_unique<acmap::RigSimulation>(
      scene, patterns, light, std::move(cameras));
}

} // namespace

/** \brief The sequence of shots, and the thread that passes them on. */
class SimulatedRigGrabber::Stream {
public:
  using Signal = boost::signals2::signal<FrameCallback>;

  Stream(const acmap::RigSimulation& simulation, const Signal& signal)
  : simulation_(simulation)
  , signal_(signal)
  , settings_{1, simulation.scene().views.size(), 0}
  , thread_([this] { return giveShot(); }, {})
  {}

  acmap::StreamThread&
  thread()
  {
    return thread_;
  }

  acmap::SequenceSettings
  settings() const
  {
    const std::lock_guard lock(mutex_);
    return settings_;
  }

  template <typename T>
  void
  set(T acmap::SequenceSettings::*setting, T value)
  {
    const std::lock_guard lock(mutex_);
    settings_.*setting = value;
  }

  void
  rewind()
  {
    is_rewound_ = true;
  }

private:
  bool
  giveShot()
  {
    if (is_rewound_.exchange(false))
      shots_.emplace(simulation_, settings());
    const TrinocularFrame::ConstPtr frame = shots_->next();
    if (frame)
      signal_(frame);
    return frame != nullptr;
  }

  const acmap::RigSimulation& simulation_;
  const Signal& signal_;
  mutable std::mutex mutex_; // protects settings_
  acmap::SequenceSettings settings_;
  std::atomic<bool> is_rewound_{true};
  std::optional<acmap::ShotSequence> shots_; // used by the thread only
  acmap::StreamThread thread_; // declared last, since its thread uses all other members
};

SimulatedRigGrabber::SimulatedRigGrabber(
    std::unique_ptr<const acmap::RigSimulation> simulation)
: StreamedGrabber("SimulatedRigGrabber")
, simulation_(std::move(simulation))
, stream_(std::make_unique<Stream>(*simulation_, *createSignal<FrameCallback>()))
{}

SimulatedRigGrabber::SimulatedRigGrabber(const SimulatedScene& scene,
                                         const std::vector<RgbImage>& patterns,
                                         const SimulatedLight& light)
: SimulatedRigGrabber(simulationOf(scene, patterns, light, acmap::raysOf(scene.rig)))
{}

SimulatedRigGrabber::SimulatedRigGrabber(const SimulatedScene& scene,
                                         const std::vector<RgbImage>& patterns,
                                         const RigCalibration& calibration,
                                         const SimulatedLight& light)
: SimulatedRigGrabber(simulationOf(scene, patterns, light, acmap::raysOf(calibration)))
{
  requireSoundRig(scene.rig);
}

SimulatedRigGrabber::~SimulatedRigGrabber() noexcept = default;

acmap::StreamThread&
SimulatedRigGrabber::stream() const
{
  return stream_->thread();
}

void
SimulatedRigGrabber::setSeed(std::uint64_t seed)
{
  stream_->set(&acmap::SequenceSettings::seed, seed);
}

std::uint64_t
SimulatedRigGrabber::getSeed() const
{
  return stream_->settings().seed;
}

void
SimulatedRigGrabber::setNumberOfObservations(std::size_t observations)
{
  acmap::requireInRange("number of observations",
                        static_cast<double>(observations),
                        1.0,
                        static_cast<double>(simulation_->scene().views.size()),
                        "(the views of the scene)");
  stream_->set(&acmap::SequenceSettings::observations, observations);
}

std::size_t
SimulatedRigGrabber::getNumberOfObservations() const
{
  return stream_->settings().observations;
}

void
SimulatedRigGrabber::setNumberOfThreads(unsigned threads)
{
  stream_->set(&acmap::SequenceSettings::threads, acmap::requiredThreads(threads));
}

unsigned
SimulatedRigGrabber::getNumberOfThreads() const
{
  return stream_->settings().threads;
}

std::size_t
SimulatedRigGrabber::getShotsOfObservation() const
{
  return simulation_->shotsOfObservation();
}

void
SimulatedRigGrabber::start()
{
  stream_->thread().add(acmap::StreamThread::endless);
}

void
SimulatedRigGrabber::trigger()
{
  stream_->thread().add(1);
}

void
SimulatedRigGrabber::rewind()
{
  stream_->rewind();
}

float
SimulatedRigGrabber::getFramesPerSecond() const
{
  return 14.0f;
}

TrinocularRig
SimulatedRigGrabber::getRig() const
{
  return simulation_->scene().rig;
}

std::vector<TrinocularFrame::Ptr>
SimulatedRigGrabber::observe(std::size_t observation) const
{
  const acmap::SequenceSettings settings = stream_->settings();
  return acmap::withThreads(settings.threads, [&] {
    const acmap::LitViews views = simulation_->cast(observation);
    std::vector<TrinocularFrame::Ptr> frames;
    for (std::size_t shot = 0; shot < simulation_->shotsOfObservation(); ++shot)
      frames.push_back(simulation_->shoot(views, observation, shot, settings.seed));
    return frames;
  });
}

} // namespace pcl
