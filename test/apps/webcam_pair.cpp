#include "webcam_pair.h"

#include "simulated_runs.h"

#include <pcl/acquisition/trinocular_recorder.h>
#include <pcl/video/video_source.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

namespace pcl::acmap::test {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::microseconds period(33333);
constexpr std::chrono::milliseconds exposure(10);

} // namespace

WebcamPair::WebcamPair(FilmedByCamera& film)
: film_(film)
{
  std::signal(SIGPIPE, SIG_IGN); // the tool may end before an image is complete
  for (const char* const name : {"reference", "horizontal"}) {
    pipes_.push_back({folder_.path(name)});
    mkfifo(pipes_.back().path.c_str(), 0600);
    devices_.push_back(
        "filesrc location=" + pipes_.back().path +
        " ! rawvideoparse format=gray8 width=" + std::to_string(film.rig().width) +
        " height=" + std::to_string(film.rig().height) + " framerate=30/1 ! appsink");
  }
  thread_ = std::thread([this] { this->film(); });
}

WebcamPair::~WebcamPair()
{
  ends_ = true;
  thread_.join();
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
    for (std::size_t camera = 0; camera < pipes_.size(); ++camera)
      if (camera == 0 || number < unplugged_at_)
        write(pipes_[camera], imageOf(camera, bytes, number));
      else if (pipes_[camera].file >= 0)
        close(std::exchange(pipes_[camera].file, -1));
    std::this_thread::sleep_until(seen.begin + period);
  }
  for (const Pipe& pipe : pipes_)
    if (pipe.file >= 0)
      close(pipe.file);
}

/** Waits while the pipe is full, or has no reader yet. */
void
WebcamPair::write(Pipe& pipe, const std::vector<std::uint8_t>& image) const
{
  while (pipe.file < 0 && !ends_) {
    pipe.file = open(pipe.path.c_str(), O_WRONLY | O_NONBLOCK);
    if (pipe.file < 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  std::size_t written = 0;
  while (written < image.size() && !ends_) {
    pollfd ready = {pipe.file, POLLOUT, 0};
    poll(&ready, 1, 20);
    const ssize_t count =
        ::write(pipe.file, image.data() + written, image.size() - written);
    if (count > 0)
      written += static_cast<std::size_t>(count);
    else if (count < 0 && errno == EPIPE) { // the tool has closed the camera
      close(std::exchange(pipe.file, -1));
      return;
    }
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
