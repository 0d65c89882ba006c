#include "digiclops/grabber_state.h"
#include "iidc/camera_state.h"

#include <pcl/acquisition/usb_camera.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/rig_cameras.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <thread>
#include <utility>

namespace pcl {

namespace {

/** Opens the same camera as the first time, even if it was plugged in elsewhere. */
struct UsbOpener {
  std::string device;
  bool is_lasting; ///< device identifies the same camera after replugging

  std::unique_ptr<IidcBus>
  operator()()
  {
    std::unique_ptr<IidcBus> bus = openUsbBus(device);
    if (!is_lasting)
      device = acmap::textOfGuid(acmap::readConfigRom(*bus).guid);
    is_lasting = true;
    return bus;
  }
};

void
waitAMoment(const std::function<void()>& idle)
{
  if (idle)
    idle();
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

/** Longer than any projector takes, whose settle time is not known yet. */
void
waitUntilSettled(const std::function<void()>& idle)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point settled = Clock::now() + std::chrono::milliseconds(700);
  while (Clock::now() < settled)
    waitAMoment(idle);
}

void
takeShot(DigiclopsGrabber& camera, const std::function<void()>& idle)
{
  camera.trigger();
  try {
    while (camera.isRunning())
      waitAMoment(idle);
  }
  catch (...) {
    camera.stop();
    throw;
  }
  if (camera.getError())
    std::rethrow_exception(camera.getError());
}

} // namespace

DigiclopsGrabber::DigiclopsGrabber(const TrinocularRig& rig, const std::string& device)
: DigiclopsGrabber(rig, UsbOpener{device, device.rfind("usb:", 0) == 0})
{}

DigiclopsGrabber::DigiclopsGrabber(const TrinocularRig& rig, IidcBusOpener opener)
: StreamedGrabber("DigiclopsGrabber")
{
  requireSoundRig(rig);
  state_.reset(new State(rig, std::move(opener)));
  state_->camera.open();
  state_->setMode(state_->findMode(), State::paper_rate);
  state_->frames = createSignal<FrameCallback>();
  state_->errors = createSignal<ErrorCallback>();
}

DigiclopsGrabber::~DigiclopsGrabber() noexcept
{
  stop();
}

acmap::StreamThread&
DigiclopsGrabber::stream() const
{
  return state_->stream;
}

IidcCamera&
DigiclopsGrabber::camera()
{
  return state_->camera;
}

void
DigiclopsGrabber::setMode(const IidcMode& mode)
{
  state_->setMode(mode, state_->wanted_rate);
}

IidcMode
DigiclopsGrabber::getMode() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->mode;
}

void
DigiclopsGrabber::setFramesPerSecond(float frames_per_second)
{
  state_->setMode(getMode(), frames_per_second);
}

void
DigiclopsGrabber::setChannelOrder(const ChannelOrder& order)
{
  if (order[0] == order[1] || order[0] == order[2] || order[1] == order[2])
    throw acmap::BadArgument("channel order " + textOf(order) +
                             " is refused: a camera is in it twice");
  const std::lock_guard lock(state_->mutex);
  state_->order = order;
  state_->is_order_fixed = true;
  state_->checks_left = max_order_checks;
}

ChannelOrder
DigiclopsGrabber::getChannelOrder() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->order;
}

void
DigiclopsGrabber::setCalibration(const RigCalibration& calibration)
{
  requireSoundCalibration(calibration);
  if (calibration.width != state_->rig.width ||
      calibration.height != state_->rig.height)
    throw acmap::BadArgument("a calibration of " + acmap::sizeText(calibration) +
                             " pixels is refused: the rig has others");
  for (const RigCamera camera : acmap::rig_cameras)
    if (acmap::hasCamera(state_->rig, camera) && !calibration.camera(camera).is_there)
      throw acmap::BadArgument("a calibration without a camera of the rig is refused");
  const std::lock_guard lock(state_->mutex);
  state_->calibration = calibration;
  state_->checks_left = max_order_checks;
}

void
DigiclopsGrabber::setTimeout(double seconds)
{
  acmap::requireInRange("timeout", seconds, 0.01, 60, "s");
  const std::lock_guard lock(state_->mutex);
  state_->timeout = seconds;
}

double
DigiclopsGrabber::getTimeout() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->timeout;
}

void
DigiclopsGrabber::start()
{
  state_->camera.open();
  state_->stream.add(acmap::StreamThread::endless);
}

void
DigiclopsGrabber::stop()
{
  const acmap::CameraStream::Interruption interruption(state_->shots);
  state_->stream.stop();
}

void
DigiclopsGrabber::trigger()
{
  if (state_->stream.isEndless())
    return;
  state_->camera.open();
  state_->stream.add(1);
}

void
DigiclopsGrabber::rewind()
{
  const std::lock_guard lock(state_->mutex);
  state_->next_number = 0;
}

float
DigiclopsGrabber::getFramesPerSecond() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->rate;
}

TrinocularRig
DigiclopsGrabber::getRig() const
{
  return state_->rig;
}

CameraFault
DigiclopsGrabber::getFault() const
{
  try {
    if (const std::exception_ptr error = getError())
      std::rethrow_exception(error);
  }
  catch (const CameraException& exception) {
    return exception.fault();
  }
  catch (...) { // a callback has thrown
  }
  return CameraFault::None;
}

DigiclopsGrabberReport
DigiclopsGrabber::getReport() const
{
  const acmap::StreamCounts counts = state_->shots.counts();
  const std::lock_guard lock(state_->mutex);
  DigiclopsGrabberReport report = state_->report;
  report.lost = static_cast<std::size_t>(std::max(counts.lost, 0L));
  report.broken = counts.broken;
  report.early = counts.early;
  report.restarts = counts.restarts;
  report.frames_per_second = state_->meter.perSecond();
  return report;
}

std::optional<ChannelOrderCheck>
checkChannelOrder(DigiclopsGrabber& camera,
                  PatternProjector& projector,
                  const std::vector<RgbImage>& patterns,
                  const std::function<void()>& idle)
{
  const std::size_t shots =
      std::min<std::size_t>(DigiclopsGrabber::max_order_checks, patterns.size());
  std::optional<ChannelOrderCheck> check;
  for (std::size_t i = 0; i < shots && !(check && check->is_certain); ++i) {
    projector.show(patterns[i]);
    waitUntilSettled(idle);
    takeShot(camera, idle);
    check = camera.getReport().order;
  }
  projector.showNothing();
  camera.rewind();
  return check;
}

} // namespace pcl
