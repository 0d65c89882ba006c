#include "session/frame_findings.h"
#include "session/frame_source.h"

#include <pcl/acquisition/trinocular_file_grabber.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>

#include <atomic>
#include <optional>
#include <utility>

namespace pcl {

namespace {

using Signal = boost::signals2::signal<TrinocularGrabber::FrameCallback>;

/** \brief Index of the next frame. */
class FramePlace {
public:
  /** \return the index, and advances it; nothing at the end */
  std::optional<std::size_t>
  next(std::size_t frames, bool repeat)
  {
    const std::lock_guard lock(mutex_);
    if (next_ == frames && repeat)
      next_ = 0;
    if (next_ >= frames)
      return std::nullopt;
    return next_++;
  }

  /** \brief Makes a frame that could not be read the next one again. */
  void
  giveBack(std::size_t index)
  {
    const std::lock_guard lock(mutex_);
    if (next_ == index + 1)
      next_ = index;
  }

  void
  rewind()
  {
    const std::lock_guard lock(mutex_);
    next_ = 0;
  }

private:
  std::mutex mutex_;
  std::size_t next_ = 0;
};

acmap::StreamThread::Seconds
periodOf(float frames_per_second)
{
  if (frames_per_second != 0.0F)
    acmap::requireInRange(
        "frames_per_second", frames_per_second, 0.001, 1000.0, "Hz, or 0");
  return acmap::StreamThread::Seconds(
      frames_per_second == 0.0F ? 0.0 : 1.0 / static_cast<double>(frames_per_second));
}

} // namespace

struct TrinocularFileGrabber::State {
  State(std::unique_ptr<acmap::FrameSource> frames,
        TrinocularFileReport report,
        float rate,
        bool is_repeated)
  : source(std::move(frames))
  , findings(std::move(report))
  , frames_per_second(rate)
  , repeat(is_repeated)
  , stream([this] { return giveFrame(); }, periodOf(rate))
  {}

  TrinocularFrame::Ptr
  read(std::size_t index)
  {
    try {
      auto frame = TrinocularFrame::Ptr(new TrinocularFrame(source->read(index)));
      findings.addRead(*frame);
      return frame;
    }
    catch (const InputFileException& exception) {
      findings.addBroken(source->number(index), exception.what());
      throw;
    }
  }

  /** One step of the stream: reads until there is a valid frame and passes it on. */
  bool
  giveFrame()
  {
    std::size_t skipped = 0;
    while (const auto index = place.next(source->size(), repeat)) {
      TrinocularFrame::ConstPtr frame;
      try {
        frame = read(*index);
      }
      catch (const InputFileException&) {
        // If no frame is valid, a repeated stream would never end.
        if (skip_broken && ++skipped < source->size())
          continue;
        place.giveBack(*index);
        throw;
      }
      (*signal)(frame);
      return true;
    }
    return false;
  }

  const std::unique_ptr<acmap::FrameSource> source;
  acmap::FrameFindings findings;
  const float frames_per_second;
  const bool repeat;
  std::atomic<bool> skip_broken{false};
  FramePlace place;
  Signal* signal = nullptr;
  acmap::StreamThread stream; // declared last, since its thread uses all other members
};

TrinocularFileGrabber::TrinocularFileGrabber(const std::string& session,
                                             float frames_per_second,
                                             bool repeat)
: StreamedGrabber("TrinocularFileGrabber")
{
  TrinocularFileReport report;
  auto source = acmap::openSession(session, report);
  state_.reset(
      new State(std::move(source), std::move(report), frames_per_second, repeat));
  state_->signal = createSignal<FrameCallback>();
}

TrinocularFileGrabber::TrinocularFileGrabber(const TrinocularImageLists& images,
                                             const TrinocularRig& rig,
                                             float frames_per_second,
                                             bool repeat)
: StreamedGrabber("TrinocularFileGrabber")
{
  TrinocularFileReport report;
  report.frames = images.reference.size();
  state_.reset(new State(acmap::openImageLists(images, rig),
                         std::move(report),
                         frames_per_second,
                         repeat));
  state_->signal = createSignal<FrameCallback>();
}

TrinocularFileGrabber::~TrinocularFileGrabber() noexcept = default;

acmap::StreamThread&
TrinocularFileGrabber::stream() const
{
  return state_->stream;
}

void
TrinocularFileGrabber::start()
{
  state_->stream.add(state_->frames_per_second > 0.0F ? acmap::StreamThread::endless
                                                      : 1);
}

void
TrinocularFileGrabber::trigger()
{
  state_->stream.add(1);
}

void
TrinocularFileGrabber::rewind()
{
  state_->place.rewind();
}

float
TrinocularFileGrabber::getFramesPerSecond() const
{
  return state_->frames_per_second;
}

TrinocularRig
TrinocularFileGrabber::getRig() const
{
  return state_->source->rig();
}

std::string
TrinocularFileGrabber::folder() const
{
  return state_->source->folder();
}

std::size_t
TrinocularFileGrabber::frames() const
{
  return state_->source->size();
}

std::optional<std::int32_t>
TrinocularFileGrabber::observationOf(std::size_t index) const
{
  return state_->source->observation(index);
}

TrinocularFrame::Ptr
TrinocularFileGrabber::frame(std::size_t index) const
{
  if (index >= frames())
    throw acmap::BadArgument("index = " + std::to_string(index) +
                             " is refused: there are " + std::to_string(frames()) +
                             " frames");
  return state_->read(index);
}

FrameFaults
TrinocularFileGrabber::faults() const
{
  TrinocularFileReport report = getReport();
  return {std::move(report.broken),
          std::move(report.saturated),
          std::move(report.black),
          std::move(report.remarks)};
}

void
TrinocularFileGrabber::setSkipBroken(bool skip)
{
  state_->skip_broken = skip;
}

bool
TrinocularFileGrabber::getSkipBroken() const
{
  return state_->skip_broken;
}

TrinocularFileReport
TrinocularFileGrabber::getReport() const
{
  return state_->findings.report();
}

} // namespace pcl
