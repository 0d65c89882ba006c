#include "webcam_pair.h"

#include "simulated_runs.h"

#include <pcl/acquisition/trinocular_recorder.h>
#include <pcl/video/video_source.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <utility>

namespace pcl::acmap::test {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::microseconds period(33333);
constexpr std::chrono::milliseconds exposure(10);

} // namespace

WebcamPair::WebcamPair(FilmedByCamera& film)
: film_(film)
{
  pipes_[0].path = folder_.path("reference");
  pipes_[1].path = folder_.path("horizontal");
  for (Pipe& pipe : pipes_) {
    mkfifo(pipe.path.c_str(), 0600);
    // GStreamer opens a file several times: there is always a writer and a reader.
    pipe.file = open(pipe.path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    devices_.push_back(
        "filesrc location=" + pipe.path +
        " ! rawvideoparse format=gray8 width=" + std::to_string(film.rig().width) +
        " height=" + std::to_string(film.rig().height) + " framerate=30/1 ! appsink");
    pipe.thread = std::thread([this, &pipe] { feed(pipe); });
  }
  thread_ = std::thread([this] { this->film(); });
}

WebcamPair::~WebcamPair()
{
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
    changed_.notify_all();
  }
  thread_.join();
  for (Pipe& pipe : pipes_) {
    pipe.thread.join();
    if (pipe.file >= 0)
      close(pipe.file);
  }
}

std::vector<std::uint8_t>
WebcamPair::imageOf(std::size_t camera,
                    const std::vector<std::uint8_t>& bytes,
                    int number) const
{
  std::vector<std::uint8_t> image(bytes.size() / 3);
  const int moved = std::max(0, number - moves_from_.load());
  for (std::size_t i = 0; i < image.size(); ++i)
    image[i] =
        bytes[3 * ((i + 5 * static_cast<std::size_t>(moved)) % image.size()) + camera];
  return image;
}

/** Exposes images; those that no reader has taken yet are replaced. */
void
WebcamPair::film()
{
  for (int number = 0; !ends_; ++number) {
    Exposure seen;
    seen.begin = Clock::now();
    seen.end = seen.begin + exposure;
    seen.setting.image_bytes =
        static_cast<std::size_t>(3 * film_.rig().width * film_.rig().height);
    std::this_thread::sleep_until(seen.end);
    const std::vector<std::uint8_t> bytes = film_.expose(seen);
    {
      const std::lock_guard lock(mutex_);
      for (std::size_t camera = 0; camera < pipes_.size(); ++camera)
        pipes_[camera].next = imageOf(camera, bytes, number);
      changed_.notify_all();
    }
    std::this_thread::sleep_until(seen.begin + period);
  }
}

void
WebcamPair::feed(Pipe& pipe)
{
  for (int written = 0;; ++written) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return ends_ || !pipe.next.empty(); });
    if (ends_)
      return;
    const std::vector<std::uint8_t> image = std::exchange(pipe.next, {});
    lock.unlock();
    if (&pipe == &pipes_[1] && written >= unplugged_at_) {
      close(std::exchange(pipe.file, -1));
      return;
    }
    write(pipe, image);
  }
}

/** Waits while the pipe is full. */
void
WebcamPair::write(const Pipe& pipe, const std::vector<std::uint8_t>& image) const
{
  std::size_t written = 0;
  while (written < image.size() && !ends_) {
    pollfd ready = {pipe.file, POLLOUT, 0};
    poll(&ready, 1, 20);
    const ssize_t count =
        ::write(pipe.file, image.data() + written, image.size() - written);
    if (count > 0)
      written += static_cast<std::size_t>(count);
  }
}

void
recordPair(const FilmedByCamera& film, const std::string& session)
{
  const TemporaryFolder folder;
  film.record(folder.path("three"));
  TrinocularRig rig = film.rig();
  rig.baseline_vertical = 0;
  TrinocularRecorder recorder(session, rig);
  for (const TrinocularFrame::ConstPtr& frame : framesOf(folder.path("three"))) {
    TrinocularFrame pair = *frame;
    pair.image(RigCamera::Vertical) = {};
    recorder.record(pair);
  }
  recorder.finish();
}

bool
canPipe()
{
  try {
    openVideo("filesrc location=/dev/zero ! rawvideoparse format=gray8 ! appsink");
    return true;
  }
  catch (const CameraException&) {
    return false;
  }
}

} // namespace pcl::acmap::test
