#include "grab_run.h"

#include "tool.h"

#include <algorithm>
#include <set>
#include <thread>

namespace pcl::acmap {

namespace {

constexpr std::chrono::milliseconds between_frames(50);

} // namespace

GrabRun::GrabRun(Tool& tool,
                 const GrabberOptions& options,
                 const Device& device,
                 GrabOutputs& outputs,
                 StatusLine& status,
                 LiveWindow* live)
: tool_(tool)
, options_(options)
, device_(device)
, outputs_(outputs)
, status_(status)
, live_(live)
, queue_(queueLength(device.frameBytes()))
, wanted_(options.observations.value_or(device.recording ? 0 : 1))
{}

GrabRun::~GrabRun()
{
  end();
  connection_.disconnect();
}

void
GrabRun::listenTo(TrinocularGrabber& grabber)
{
  grabber_ = &grabber;
  const std::function<TrinocularGrabber::FrameCallback> queue =
      [this](const TrinocularFrame::ConstPtr& frame) { queue_.push(frame); };
  connection_ = grabber.registerCallback(queue);
}

/** Closes the queue first, since a grabber that waits for room in the queue could not
 * stop. Frames in the queue are kept. */
void
GrabRun::end()
{
  queue_.close();
  if (grabber_)
    grabber_->stop();
}

/** Processes frames until the stream is over and the queue is empty. */
void
GrabRun::pump(const UseFrame& use, const std::function<bool()>& is_over)
{
  for (;;) {
    const bool is_running = grabber_->isRunning();
    const TrinocularFrame::ConstPtr frame = queue_.pop(between_frames);
    if (frame) {
      ++frames_;
      if (live_)
        live_->show(*frame);
      if (!use(frame)) {
        end();
        return;
      }
    }
    else if (!is_running)
      break;
    if (is_over())
      end();
    idle();
  }
  if (grabber_->getError())
    std::rethrow_exception(grabber_->getError());
}

/** Likewise; only an error or the user ends the stream early. */
void
GrabRun::pumpAll(const UseFrame& use)
{
  pump(use, [&] {
    tool_.stopIfInterrupted();
    return false;
  });
}

void
GrabRun::idle()
{
  if (live_)
    live_->update();
  tellStatus(doing());
}

void
GrabRun::passRecording()
{
  const std::vector<std::uint64_t> doubled = device_.recording->getReport().doubled;
  const std::set<std::uint64_t> left_out(doubled.begin(), doubled.end());
  listenTo(*device_.recording);
  grabber_->start();
  const auto use = [&](const TrinocularFrame::ConstPtr& frame) {
    if (left_out.count(frame->number) > 0)
      return true;
    const auto open = outputs_.openObservation();
    const bool is_next = open && *open != static_cast<std::size_t>(frame->observation);
    if (is_next && outputs_.observations() + 1 == wanted_)
      return false;
    shots_ = is_next ? 1 : shots_ + 1;
    outputs_.take(frame, progress());
    return true;
  };
  pumpAll(use);
  outputs_.close(progress());
}

void
GrabRun::passStream()
{
  using Clock = std::chrono::steady_clock;
  const bool has_end = options_.frames > 0 || options_.seconds > 0;
  listenTo(*device_.camera);
  grabber_->start();
  const Clock::time_point begin = Clock::now();
  const auto use = [&](const TrinocularFrame::ConstPtr& frame) {
    outputs_.take(frame, progress());
    outputs_.close(progress());
    return frames_ != options_.frames;
  };
  pump(use, [&] {
    if (has_end)
      tool_.stopIfInterrupted();
    const std::chrono::duration<double> passed = Clock::now() - begin;
    const bool is_for_window = options_.session.empty();
    return interrupted() || (is_for_window && live_->isClosed()) ||
           (options_.seconds > 0 && passed.count() >= options_.seconds);
  });
}

void
GrabRun::passObservations(PatternSequenceGrabber& sequence)
{
  if (options_.early) {
    need_.emplace(rectifierOf(options_, device_, tool_.threads()));
    sequence.setWantMore(
        [this](const TrinocularFrame& frame) { return need_->wantsMoreAfter(frame); });
  }
  listenTo(sequence);
  Pacing pacing(options_.every);
  for (std::size_t i = 0; i < wanted_; ++i) {
    const auto wait = [&] {
      tool_.stopIfInterrupted();
      idle();
    };
    if (i > 0 && pacing.asks())
      status_.note("Enter takes observation " + std::to_string(i) + " of " +
                   std::to_string(wanted_) + ", q and Enter ends");
    if (i > 0 && !pacing.wait(wait))
      break;
    pacing.begin();
    shots_ = 0;
    sequence.observe();
    const auto use = [&](const TrinocularFrame::ConstPtr& frame) {
      ++shots_;
      outputs_.take(frame, progress());
      return true;
    };
    pumpAll(use);
    outputs_.close(progress());
  }
}

void
GrabRun::waitForWindow()
{
  if (!live_ || live_->isClosed() || interrupted())
    return;
  status_.note("done; close the window to end");
  while (!live_->isClosed() && !interrupted()) {
    live_->update();
    std::this_thread::sleep_for(between_frames);
  }
}

ProgressCallback
GrabRun::progress()
{
  return [this](double, const std::string& step) {
    if (live_)
      live_->update();
    tellStatus(step);
    return !interrupted();
  };
}

std::string
GrabRun::doing() const
{
  if (options_.isStream())
    return "";
  return "observation " + std::to_string(outputs_.observations()) + ", shot " +
         std::to_string(shots_);
}

void
GrabRun::tellStatus(const std::string& step)
{
  if (!status_.isDue())
    return;
  GrabStatus now;
  now.frames = frames_;
  now.written = outputs_.written();
  now.free = outputs_.free();
  now.doing = step;
  if (device_.camera) {
    const DigiclopsGrabberReport report = device_.camera->getReport();
    now.frames_per_second = report.frames_per_second;
    now.lost = report.lost;
    now.broken = report.broken;
  }
  else
    now.broken = device_.recording->getReport().broken.size();
  status_.show(statusText(now));
}

} // namespace pcl::acmap
