#include "camera_set.h"
#include "scene_change.h"
#include "video_device.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/rig_cameras.h>
#include <pcl/video/camera_grabber.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cmath>
#include <deque>
#include <mutex>
#include <sstream>
#include <utility>

namespace pcl {

namespace {

using acmap::CameraSet;
using acmap::ImageSet;

constexpr double usual_rate = 30;              // Hz, of a camera that does not tell it
constexpr int max_broken = 10;                 // incomplete images in a row
constexpr std::uint64_t rate_window = 2000000; // microseconds

void
requireUpTo(const char* name, unsigned value, unsigned maximum)
{
  acmap::requireInRange(name, value, 0, maximum, "images");
}

void
requireDevices(const TrinocularRig& rig, const std::vector<std::string>& devices)
{
  const auto cameras = static_cast<std::size_t>(acmap::countCameras(rig));
  if (devices.size() != cameras)
    throw acmap::BadArgument(std::to_string(devices.size()) +
                             " cameras are refused: the rig has " +
                             std::to_string(cameras));
  if (cameras < 2)
    throw acmap::BadArgument("a rig of one camera is refused: a baseline is needed");
  for (std::size_t i = 0; i < devices.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (acmap::isSameVideo(devices[i], devices[j]))
        throw acmap::BadArgument(devices[j] + " and " + devices[i] +
                                 " are refused: they are one camera");
}

/** \brief The largest change of any camera, and the camera that saw it. */
struct Change {
  double levels = 0; // grey levels
  RigCamera camera = RigCamera::Reference;
};

Change
changeBetween(const ImageSet& before, const ImageSet& after)
{
  Change largest;
  for (const RigCamera camera : acmap::rig_cameras) {
    const auto i = static_cast<std::size_t>(camera);
    const double levels = acmap::sceneChange(before.images[i], after.images[i]);
    if (levels > largest.levels)
      largest = {levels, camera};
  }
  return largest;
}

/** \brief Settings of exposure and gain. */
struct Controls {
  std::optional<double> exposure; // s
  bool is_automatic = false;
  std::optional<double> gain;
};

[[noreturn]] void
throwRefused(const std::string& device, const std::string& what, double value)
{
  std::ostringstream text;
  text << device << ": refuses " << what << " = " << value;
  throw CameraException(CameraFault::Unsupported, text.str());
}

/** Sets exposure, gain, white balance and focus of a camera.
 * \return is its exposure fixed? */
bool
setControls(const std::string& device, const Controls& wanted, VideoSource& camera)
{
  if (wanted.gain && !camera.set(VideoSetting::Gain, *wanted.gain))
    throwRefused(device, "gain", *wanted.gain);
  camera.set(VideoSetting::AutomaticWhiteBalance, 0);
  camera.set(VideoSetting::AutomaticFocus, 0);
  if (wanted.is_automatic) {
    camera.set(VideoSetting::AutomaticExposure, 1);
    return false;
  }
  const auto current = camera.get(VideoSetting::Exposure);
  const bool is_manual = camera.set(VideoSetting::AutomaticExposure, 0);
  if (wanted.exposure) {
    if (!camera.set(VideoSetting::Exposure, *wanted.exposure))
      throwRefused(device, "exposure", *wanted.exposure);
    return true;
  }
  // a camera that is set to manual may go back to an older exposure
  if (is_manual && current)
    camera.set(VideoSetting::Exposure, *current);
  return is_manual;
}

} // namespace

/** \brief Implementation of the grabber. */
struct CameraGrabber::State {
  State(const TrinocularRig& frame_rig,
        std::vector<std::string> names,
        VideoOpener video_opener)
  : rig(frame_rig)
  , devices(std::move(names))
  , opener(std::move(video_opener))
  , stream(
        [this] { return give(); }, acmap::StreamThread::Seconds(0), [this] { end(); })
  {
    report.cameras.resize(devices.size());
  }

  /** Opens the cameras, unless they are open, and grabs the first image of each. */
  void
  open()
  {
    if (is_format_new.exchange(false))
      cameras.reset();
    if (cameras)
      return;
    std::string format;
    double seconds = 0;
    {
      const std::lock_guard lock(mutex);
      format = pixel_format;
      seconds = timeout;
    }
    auto opened = std::make_unique<CameraSet>(rig, devices, opener, format);
    ImageSet images;
    const CameraSet::Outcome outcome = opened->grab(seconds, stops);
    if (outcome == CameraSet::Outcome::Stopped)
      return;
    if (outcome == CameraSet::Outcome::End)
      throw InputFileException(devices.front() + ": has no image");
    if (opened->retrieve(images) == CameraSet::Outcome::Images)
      acmap::requireDifferentImages(*opened, images);
    cameras = std::move(opened);
    has_grabbed = true;
    is_warm = false;
    const std::lock_guard lock(mutex);
    describeCameras();
  }

  /** Must be called with the mutex locked. */
  void
  describeCameras()
  {
    double rate = 0;
    for (std::size_t i = 0; i < devices.size(); ++i) {
      VideoSource& source = cameras->cameras()[i].thread->source();
      CameraState& state = report.cameras[i];
      state.device = devices[i];
      state.is_recording = source.isRecording();
      state.frames_per_second = source.get(VideoSetting::FramesPerSecond).value_or(0);
      state.exposure = source.get(VideoSetting::Exposure);
      state.gain = source.get(VideoSetting::Gain);
      rate = std::max(rate, state.frames_per_second);
    }
    camera_rate = rate > 0 ? rate : usual_rate;
  }

  /** Must be called with the mutex locked. \return images of the cameras per frame of a
   * stream */
  int
  stride() const
  {
    return wanted_rate > 0
               ? std::max(1, static_cast<int>(std::lround(camera_rate / wanted_rate)))
               : 1;
  }

  /** Grabs the next images. The first ones were grabbed when the cameras were opened. */
  CameraSet::Outcome
  grab()
  {
    if (std::exchange(has_grabbed, false))
      return CameraSet::Outcome::Images;
    double seconds = 0;
    {
      const std::lock_guard lock(mutex);
      seconds = timeout;
    }
    return cameras->grab(seconds, stops);
  }

  CameraSet::Outcome
  discard(unsigned count)
  {
    for (unsigned i = 0; i < count; ++i) {
      const CameraSet::Outcome outcome = grab();
      if (outcome != CameraSet::Outcome::Images)
        return outcome;
      const std::lock_guard lock(mutex);
      ++report.discarded;
    }
    return CameraSet::Outcome::Images;
  }

  /** Grabs and converts the next images; incomplete ones are passed over.
   * \throws CameraException Corrupt if too many are incomplete */
  CameraSet::Outcome
  next(ImageSet& images)
  {
    for (int i = 0; i <= max_broken; ++i) {
      const CameraSet::Outcome outcome = grab();
      if (outcome != CameraSet::Outcome::Images)
        return outcome;
      if (cameras->retrieve(images) == CameraSet::Outcome::Images)
        return CameraSet::Outcome::Images;
      const std::lock_guard lock(mutex);
      ++report.broken;
    }
    throw CameraException(CameraFault::Corrupt,
                          "the cameras give incomplete images only");
  }

  /** After the cameras were opened: waits for their automatic settings, then fixes
   * them. */
  CameraSet::Outcome
  warmUp()
  {
    if (is_warm && !are_controls_new)
      return CameraSet::Outcome::Images;
    Controls wanted;
    unsigned images = 0;
    {
      const std::lock_guard lock(mutex);
      wanted = controls;
      images = is_warm ? 0 : warm_up_frames;
      are_controls_new = false;
    }
    if (images == 0 && cameras->isGrabbing()) // settings are made between two images
      images = 1;
    const CameraSet::Outcome outcome = discard(images);
    if (outcome != CameraSet::Outcome::Images)
      return outcome;
    for (std::size_t i = 0; i < devices.size(); ++i) {
      const bool is_fixed =
          setControls(devices[i], wanted, cameras->cameras()[i].thread->source());
      const std::lock_guard lock(mutex);
      report.cameras[i].is_exposure_fixed = is_fixed;
      if (!is_fixed && !wanted.is_automatic && !report.cameras[i].is_recording)
        report.remarks.push_back(devices[i] + ": its exposure cannot be fixed; it may "
                                              "change between shots");
    }
    is_warm = true;
    const std::lock_guard lock(mutex);
    describeCameras();
    return outcome;
  }

  /** One step of the stream: passes one frame to the callbacks. */
  bool
  give()
  {
    const bool is_shot = !stream.isEndless();
    open();
    if (!cameras)
      return false; // stopped
    ImageSet images;
    Change change;
    CameraSet::Outcome outcome = warmUp();
    if (outcome == CameraSet::Outcome::Images)
      outcome = is_shot ? takeShot(images, change) : takeNext(images, change);
    if (outcome == CameraSet::Outcome::End && is_shot)
      throw CameraException(CameraFault::Silent,
                            "the recording ended before the shot was complete");
    if (outcome != CameraSet::Outcome::Images)
      return false;
    (*frames)(frameOf(images, change));
    return true;
  }

  /** Takes the first images after the buffered ones in which the scene stands still. */
  CameraSet::Outcome
  takeShot(ImageSet& images, Change& change)
  {
    unsigned discarded = 0;
    unsigned retries = 0;
    double maximum = 0;
    {
      const std::lock_guard lock(mutex);
      discarded = discarded_frames;
      retries = maximum_retries;
      maximum = maximum_change;
    }
    CameraSet::Outcome outcome = discard(discarded);
    ImageSet before;
    if (outcome == CameraSet::Outcome::Images)
      outcome = next(before);
    for (unsigned i = 0; outcome == CameraSet::Outcome::Images; ++i) {
      outcome = next(images);
      if (outcome != CameraSet::Outcome::Images)
        break;
      change = changeBetween(before, images);
      if (change.levels <= maximum) {
        if (i > 0)
          remarkOnRetries(i);
        break;
      }
      countMove();
      if (i == retries)
        throwMoving(change, maximum, i + 2);
      std::swap(before, images);
    }
    previous = std::nullopt;
    return outcome;
  }

  /** Takes the next images of a stream in which the scene stands still. */
  CameraSet::Outcome
  takeNext(ImageSet& images, Change& change)
  {
    for (;;) {
      unsigned passed = 0;
      double maximum = 0;
      {
        const std::lock_guard lock(mutex);
        passed = static_cast<unsigned>(stride());
        maximum = maximum_change;
      }
      if (passed > 1)
        previous = std::nullopt;
      CameraSet::Outcome outcome =
          passed > 2 ? discard(passed - 2) : CameraSet::Outcome::Images;
      if (outcome == CameraSet::Outcome::Images && !previous)
        outcome = next(previous.emplace());
      if (outcome == CameraSet::Outcome::Images)
        outcome = next(images);
      if (outcome != CameraSet::Outcome::Images)
        return outcome;
      change = changeBetween(*previous, images);
      previous = images;
      if (change.levels <= maximum)
        return outcome;
      countMove();
    }
  }

  void
  countMove()
  {
    const std::lock_guard lock(mutex);
    ++report.moved;
  }

  void
  remarkOnRetries(unsigned images)
  {
    const std::lock_guard lock(mutex);
    report.remarks.push_back("frame " + std::to_string(next_number) +
                             ": the scene moved for " + std::to_string(images) +
                             " images before it stood still");
  }

  [[noreturn]] static void
  throwMoving(const Change& change, double maximum, unsigned images)
  {
    std::ostringstream text;
    text << "the scene moves: two successive images of the " << nameOf(change.camera)
         << " camera differ by " << change.levels << " grey levels, " << maximum
         << " are allowed, and it did not stand still within " << images
         << " images; do rig and scene stand still, has the projector settled, does "
            "no lamp flicker?";
    throw CameraException(CameraFault::Moving, text.str());
  }

  TrinocularFrame::Ptr
  frameOf(ImageSet& images, const Change& change)
  {
    TrinocularFrame::Ptr frame(new TrinocularFrame);
    frame->images = std::move(images.images);
    frame->stamp = images.stamp;
    const std::lock_guard lock(mutex);
    frame->number = next_number++;
    frame->observation = static_cast<std::int32_t>(frame->number & 0x7FFFFFFF);
    ++report.frames;
    report.largest_change = std::max(report.largest_change, change.levels);
    stamps.push_back(frame->stamp);
    while (stamps.size() > 2 && stamps.back() - stamps.front() > rate_window)
      stamps.pop_front();
    return frame;
  }

  /** At the end of a stream. After a fault the cameras are closed: the next stream opens
   * them again. */
  void
  end()
  {
    previous = std::nullopt;
    try {
      if (const std::exception_ptr error = stream.error())
        std::rethrow_exception(error);
    }
    catch (const CameraException& exception) {
      if (exception.fault() != CameraFault::Moving)
        cameras.reset();
    }
    catch (...) { // a callback has thrown; the cameras work
    }
  }

  void
  request(std::size_t frame_count)
  {
    std::unique_lock lock(requests, std::defer_lock);
    if (!stream.isWithin())
      lock.lock();
    stream.add(frame_count);
  }

  void
  stop()
  {
    if (stream.isWithin()) {
      stream.stop();
      return;
    }
    ++stops; // at once: it ends a wait for an image
    const std::lock_guard lock(requests);
    stream.stop();
    --stops;
  }

  const TrinocularRig rig;
  const std::vector<std::string> devices;
  const VideoOpener opener;
  boost::signals2::signal<FrameCallback>* frames = nullptr;
  std::mutex requests; // locked while threads other than the stream's start or stop it
  std::atomic<int> stops{0}; // calls of stop that have not returned
  std::atomic<bool> are_controls_new{false};
  std::atomic<bool> is_format_new{false};

  // Protects the members up to the next empty line; not held in callbacks.
  mutable std::mutex mutex;
  std::string pixel_format;
  Controls controls;
  double wanted_rate = 0; // Hz; 0: that of the cameras
  double camera_rate = usual_rate;
  unsigned warm_up_frames = 10;
  unsigned discarded_frames = 5;
  unsigned maximum_retries = 60;
  double maximum_change = 4; // grey levels
  double timeout = 5;        // s
  std::uint64_t next_number = 0;
  std::deque<std::uint64_t> stamps; // of recent frames
  CameraGrabberReport report;

  // used by the thread of the stream, and by the constructor
  std::unique_ptr<CameraSet> cameras;
  bool has_grabbed = false; // an image that was not used
  bool is_warm = false;
  std::optional<ImageSet> previous; // of a stream

  acmap::StreamThread stream; // declared last, since its thread uses all other members
};

CameraGrabber::CameraGrabber(const TrinocularRig& rig,
                             const std::vector<std::string>& devices,
                             VideoOpener opener)
: StreamedGrabber("CameraGrabber")
{
  requireSoundRig(rig);
  requireDevices(rig, devices);
  if (!opener)
    throw acmap::BadArgument("there is nothing that opens cameras");
  state_.reset(new State(rig, devices, std::move(opener)));
  state_->open();
  state_->frames = createSignal<FrameCallback>();
}

CameraGrabber::~CameraGrabber() noexcept
{
  stop();
}

acmap::StreamThread&
CameraGrabber::stream() const
{
  return state_->stream;
}

void
CameraGrabber::setFramesPerSecond(float frames_per_second)
{
  acmap::requireInRange("frames_per_second", frames_per_second, 0.001, 1000, "Hz");
  const std::lock_guard lock(state_->mutex);
  state_->wanted_rate = frames_per_second;
}

void
CameraGrabber::setWarmUpFrames(unsigned frames)
{
  requireUpTo("warm_up_frames", frames, 10000);
  const std::lock_guard lock(state_->mutex);
  state_->warm_up_frames = frames;
}

unsigned
CameraGrabber::getWarmUpFrames() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->warm_up_frames;
}

void
CameraGrabber::setDiscardedFrames(unsigned frames)
{
  requireUpTo("discarded_frames", frames, 1000);
  const std::lock_guard lock(state_->mutex);
  state_->discarded_frames = frames;
}

unsigned
CameraGrabber::getDiscardedFrames() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->discarded_frames;
}

void
CameraGrabber::setMaximumChange(double levels)
{
  if (levels == 0.0)
    throw acmap::BadArgument("maximum_change = 0 is refused: images have noise");
  acmap::requireInRange("maximum_change", levels, 0, 255, "grey levels");
  const std::lock_guard lock(state_->mutex);
  state_->maximum_change = levels;
}

double
CameraGrabber::getMaximumChange() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->maximum_change;
}

void
CameraGrabber::setMaximumRetries(unsigned images)
{
  requireUpTo("maximum_retries", images, 100000);
  const std::lock_guard lock(state_->mutex);
  state_->maximum_retries = images;
}

unsigned
CameraGrabber::getMaximumRetries() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->maximum_retries;
}

void
CameraGrabber::setTimeout(double seconds)
{
  acmap::requireInRange("timeout", seconds, 0.01, 600, "s");
  const std::lock_guard lock(state_->mutex);
  state_->timeout = seconds;
}

double
CameraGrabber::getTimeout() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->timeout;
}

void
CameraGrabber::setPixelFormat(const std::string& format)
{
  const bool is_printable =
      std::all_of(format.begin(), format.end(), [](unsigned char character) {
        return std::isprint(character) != 0;
      });
  if (!format.empty() && (format.size() != 4 || !is_printable))
    throw acmap::BadArgument("pixel_format = '" + format.substr(0, 40) +
                             "' is refused: four characters are needed, as in MJPG");
  const std::lock_guard lock(state_->mutex);
  state_->is_format_new = state_->is_format_new || state_->pixel_format != format;
  state_->pixel_format = format;
}

std::string
CameraGrabber::getPixelFormat() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->pixel_format;
}

void
CameraGrabber::setExposure(double seconds)
{
  acmap::requireInRange("exposure", seconds, 1e-6, 60, "s");
  const std::lock_guard lock(state_->mutex);
  state_->controls.exposure = seconds;
  state_->controls.is_automatic = false;
  state_->are_controls_new = true;
}

void
CameraGrabber::setAutomaticExposure(bool is_automatic)
{
  const std::lock_guard lock(state_->mutex);
  state_->controls.exposure = std::nullopt;
  state_->controls.is_automatic = is_automatic;
  state_->are_controls_new = true;
}

void
CameraGrabber::setGain(double gain)
{
  acmap::requireInRange("gain", gain, -1e6, 1e6, "units of the driver");
  const std::lock_guard lock(state_->mutex);
  state_->controls.gain = gain;
  state_->are_controls_new = true;
}

void
CameraGrabber::start()
{
  state_->request(acmap::StreamThread::endless);
}

void
CameraGrabber::stop()
{
  state_->stop();
}

void
CameraGrabber::trigger()
{
  if (!state_->stream.isEndless())
    state_->request(1);
}

void
CameraGrabber::rewind()
{
  const std::lock_guard lock(state_->mutex);
  state_->next_number = 0;
}

float
CameraGrabber::getFramesPerSecond() const
{
  const std::lock_guard lock(state_->mutex);
  return static_cast<float>(state_->camera_rate / state_->stride());
}

TrinocularRig
CameraGrabber::getRig() const
{
  return state_->rig;
}

CameraGrabberReport
CameraGrabber::getReport() const
{
  const std::lock_guard lock(state_->mutex);
  CameraGrabberReport report = state_->report;
  const std::deque<std::uint64_t>& stamps = state_->stamps;
  if (stamps.size() > 1 && stamps.back() > stamps.front())
    report.frames_per_second = static_cast<double>(stamps.size() - 1) * 1e6 /
                               static_cast<double>(stamps.back() - stamps.front());
  return report;
}

} // namespace pcl
