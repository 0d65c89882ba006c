#include "grabber_state.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/rig_cameras.h>

#include <utility>

namespace pcl {

namespace {

using Way = acmap::CameraStream::Way;

ChannelOrder
defaultOrder(const TrinocularRig& rig)
{
  if (!acmap::hasCamera(rig, RigCamera::Horizontal))
    return {RigCamera::Reference, RigCamera::Vertical, RigCamera::Horizontal};
  return {RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical};
}

} // namespace

DigiclopsGrabber::State::State(const TrinocularRig& frame_rig, IidcBusOpener opener)
: rig(frame_rig)
, camera(std::move(opener))
, order(defaultOrder(frame_rig))
, calibration(calibrationOf(frame_rig))
, shots(camera)
, stream([this] { return give(); }, acmap::StreamThread::Seconds(0), [this] { end(); })
{}

IidcMode
DigiclopsGrabber::State::findMode() const
{
  return camera.findMode(rig.width, rig.height, acmap::countCameras(rig));
}

void
DigiclopsGrabber::State::requireIdle() const
{
  if (stream.isRunning())
    throw acmap::InitFailed("the mode cannot be changed while the camera streams");
}

void
DigiclopsGrabber::State::setMode(const IidcMode& new_mode, float new_rate)
{
  if (new_mode.width != rig.width || new_mode.height != rig.height ||
      new_mode.cameras() != acmap::countCameras(rig))
    throw acmap::BadArgument("mode " + new_mode.text() + " is refused: the rig has " +
                             std::to_string(acmap::countCameras(rig)) + " cameras of " +
                             acmap::sizeText(rig) + " pixels");
  requireIdle();
  const float possible = camera.setMode(new_mode, new_rate);
  const acmap::BayerPattern pattern = acmap::bayerPatternOf(camera.colorFilter());
  const std::lock_guard lock(mutex);
  mode = new_mode;
  wanted_rate = new_rate;
  rate = possible;
  bayer = pattern;
}

/** One step of the stream: reads a frame and passes it to the callbacks. */
bool
DigiclopsGrabber::State::give()
{
  {
    const std::lock_guard lock(mutex);
    shots.setUp(mode, rate, timeout);
  }
  if (!shots.next(stream.isEndless() ? Way::Free : Way::Single, shot))
    return false;
  const TrinocularFrame::Ptr frame = unpack(shot);
  (*frames)(frame);
  return true;
}

TrinocularFrame::Ptr
DigiclopsGrabber::State::unpack(acmap::WholeFrame& whole)
{
  if (camera.hasFrameCounter())
    acmap::coverCounter(whole.data, mode, bayer == acmap::BayerPattern::None ? 1 : 2);
  auto frame = TrinocularFrame::Ptr(new TrinocularFrame);
  const std::lock_guard lock(mutex);
  acmap::unpackFrame(whole.data.bytes,
                     {mode.width, mode.height, mode.cameras(), order, bayer},
                     *frame);
  frame->number = next_number + whole.lost;
  frame->observation = static_cast<std::int32_t>(frame->number & 0x7FFFFFFF);
  frame->stamp = whole.data.stamp;
  next_number = frame->number + 1;
  checkOrder(whole.data, *frame);
  meter.add(frame->stamp);
  ++report.frames;
  return frame;
}

/** Checks the order of three cameras; must be called with the mutex locked. */
void
DigiclopsGrabber::State::checkOrder(const IidcFrame& raw, TrinocularFrame& frame)
{
  if (mode.cameras() < 3 || checks_left == 0)
    return;
  --checks_left;
  report.order = checkChannelOrder(frame, order, calibration);
  if (!report.order->is_certain)
    return;
  checks_left = 0;
  if (report.order->best == order)
    return;
  const std::string found = "frame " + std::to_string(frame.number) +
                            " shows the cameras in the order " +
                            textOf(report.order->best);
  if (is_order_fixed) {
    report.remarks.push_back(found + ", not " + textOf(order) + " as was set");
    return;
  }
  report.remarks.push_back(found + ", which is taken from now on");
  order = report.order->best;
  acmap::unpackFrame(
      raw.bytes, {mode.width, mode.height, mode.cameras(), order, bayer}, frame);
}

void
DigiclopsGrabber::State::end()
{
  shots.end();
  const std::exception_ptr error = stream.error();
  if (!error)
    return;
  try {
    std::rethrow_exception(error);
  }
  catch (const CameraException& exception) {
    camera.close(); // a lost camera is reopened by the next start
    (*errors)(exception);
  }
  catch (...) { // a callback has thrown; the camera works
  }
}

} // namespace pcl
