#include "iidc/camera_state.h"

#include <pcl/acquisition/iidc_bus.h>
#include <pcl/acquisition/iidc_camera.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/size_text.h>

#include <utility>

namespace pcl {

namespace iidc = acmap::iidc;

struct IidcCamera::State : acmap::CameraState {
  using CameraState::CameraState;

  /** Sets a feature now, and again each time the camera is opened. */
  void
  set(IidcFeature feature, const acmap::FeatureSetting& setting)
  {
    if (feature == IidcFeature::FrameRate)
      throw acmap::BadArgument("frame rate is refused: setMode sets it");
    const std::lock_guard lock(mutex);
    acmap::writeFeature(registers(), feature, setting);
    wanted.features.insert_or_assign(feature, setting);
  }
};

IidcCamera::IidcCamera(IidcBusOpener opener)
: state_(new State(std::move(opener)))
{}

IidcCamera::~IidcCamera() = default;

void
IidcCamera::open()
{
  const std::lock_guard lock(state_->mutex);
  if (!isOpen())
    state_->open();
}

void
IidcCamera::close() noexcept
{
  state_->exchangeBus(nullptr);
}

bool
IidcCamera::isOpen() const
{
  return state_->isOpen();
}

std::string
IidcCamera::place() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->place;
}

IidcIdentity
IidcCamera::identity() const
{
  const std::lock_guard lock(state_->mutex);
  const acmap::ConfigRom& rom = state_->rom;
  return {rom.maker, rom.model, rom.guid, versionText(rom)};
}

std::vector<IidcMode>
IidcCamera::modes() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->modes;
}

IidcMode
IidcCamera::findMode(int width, int height, int cameras) const
{
  const std::lock_guard lock(state_->mutex);
  const IidcMode* best = nullptr;
  std::string known;
  for (const IidcMode& mode : state_->modes) {
    known += (known.empty() ? "" : ", ") + mode.text();
    if (mode.width == width && mode.height == height && mode.cameras() == cameras &&
        (best == nullptr || best->format < mode.format))
      best = &mode;
  }
  if (best != nullptr)
    return *best;
  throw CameraException(CameraFault::Unsupported,
                        state_->place + ": has no mode of " +
                            acmap::sizeText(width, height) + " pixels for " +
                            std::to_string(cameras) + " cameras; it has " +
                            (known.empty() ? "none" : known));
}

std::string
IidcCamera::colorFilter() const
{
  const std::lock_guard lock(state_->mutex);
  return colorFilterOf(*state_);
}

float
IidcCamera::setMode(const IidcMode& mode, float frames_per_second)
{
  acmap::requireInRange("frames_per_second", frames_per_second, 1e-3, 1000, "Hz");
  const std::lock_guard lock(state_->mutex);
  acmap::WantedSettings before = state_->wanted;
  state_->wanted.mode = mode;
  state_->wanted.rate = frames_per_second;
  try {
    state_->applyMode();
  }
  catch (...) {
    // The state of the registers is unknown now: no stream before a mode was set.
    state_->wanted = std::move(before);
    state_->stream = {};
    throw;
  }
  return state_->stream.rate;
}

IidcFeatureState
IidcCamera::feature(IidcFeature feature) const
{
  const std::lock_guard lock(state_->mutex);
  return acmap::readFeature(state_->registers(), feature);
}

void
IidcCamera::setValue(IidcFeature feature, unsigned value)
{
  state_->set(feature, acmap::StepSetting{value});
}

void
IidcCamera::setPhysical(IidcFeature feature, float value)
{
  state_->set(feature, acmap::PhysicalSetting{value});
}

void
IidcCamera::setAutomatic(IidcFeature feature)
{
  state_->set(feature, acmap::AutomaticSetting{});
}

void
IidcCamera::setTrigger(IidcTrigger trigger)
{
  const std::lock_guard lock(state_->mutex);
  acmap::writeTrigger(state_->registers(), trigger);
  state_->wanted.trigger = trigger;
}

IidcTrigger
IidcCamera::trigger() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->wanted.trigger;
}

bool
IidcCamera::hasOneShot() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->has_one_shot;
}

bool
IidcCamera::hasFrameCounter() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->has_counter;
}

void
IidcCamera::startStream(std::size_t frames)
{
  const std::lock_guard lock(state_->mutex);
  if (state_->stream.frame_bytes == 0)
    throw CameraException(CameraFault::Unsupported,
                          state_->place + ": no mode was set");
  state_->requireBus()->startStream(state_->stream.frame_bytes, frames);
}

void
IidcCamera::runFreely()
{
  const std::lock_guard lock(state_->mutex);
  state_->registers().write(iidc::iso_enable, iidc::on);
}

void
IidcCamera::takeOne()
{
  const std::lock_guard lock(state_->mutex);
  if (!state_->has_one_shot)
    throw CameraException(CameraFault::Unsupported,
                          state_->place + ": has no one-shot");
  state_->registers().write(iidc::one_shot, iidc::on);
}

IidcWait
IidcCamera::nextFrame(IidcFrame& frame, std::chrono::milliseconds timeout)
{
  return state_->requireBus()->nextFrame(frame, timeout);
}

void
IidcCamera::stopStream() noexcept
{
  try {
    const std::lock_guard lock(state_->mutex);
    const std::shared_ptr<IidcBus> bus = state_->requireBus();
    try {
      state_->registers().write(iidc::iso_enable, 0);
    }
    catch (...) { // the camera was removed; the bus still has to release its memory
    }
    bus->stopStream();
  }
  catch (...) { // the camera is closed
  }
}

void
IidcCamera::cancel() noexcept
{
  try {
    state_->requireBus()->cancel();
  }
  catch (...) { // the camera is closed
  }
}

IidcBus::~IidcBus() = default;

} // namespace pcl
