#include "digiclops_tables.h"
#include "frame_bytes.h"
#include "markdown_row.h"
#include "temporary_folder.h"
#include "timing.h"
#include "units.h"
#include "usb_testbed.h"

#include <pcl/acquisition/digiclops_grabber.h>
#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/acquisition/trinocular_file_grabber.h>
#include <pcl/acquisition/trinocular_recorder.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/standard_scenes.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>
#include <future>
#include <iostream>
#include <stdexcept>

namespace pcl::acmap::bench {

namespace {

constexpr std::size_t frames_wanted = 840; // one minute
constexpr float rate = 14;                 // as in the paper
constexpr std::size_t max_waiting = 28;    // two seconds

/** Bytes of shots in the format of the camera. */
std::vector<std::vector<std::uint8_t>>
filmBytes(const std::string& tiles)
{
  constexpr std::uint32_t patterns = 10;
  RandomLinePattern lines;
  std::vector<RgbImage> images;
  for (std::uint32_t i = 0; i < patterns; ++i)
    images.push_back(lines.generate(i));
  const SimulatedRigGrabber grabber(standardScene("corridor"), images);
  std::vector<std::vector<std::uint8_t>> shots;
  for (const TrinocularFrame::Ptr& frame : grabber.observe(4)) {
    for (CameraImage& image : frame->images)
      image = test::mosaicOf(image, tiles == "YYYY" ? "GGGG" : tiles);
    shots.push_back(test::interleaved(
        *frame, {RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical}));
  }
  return shots;
}

/** Timing of the frames of a stream. */
struct StreamFigures {
  std::size_t frames = 0;
  std::uint64_t first_stamp = 0;
  std::uint64_t last_stamp = 0;
  std::uint64_t last_number = 0;
  std::vector<double> grabs; ///< CPU seconds of the stream's thread between callbacks
  std::vector<double> waits; ///< wall seconds in the callbacks
  double process = 0;        ///< CPU seconds
  DigiclopsGrabberReport report;

  double
  rate() const
  {
    return 1e6 * static_cast<double>(frames - 1) /
           static_cast<double>(last_stamp - first_stamp);
  }

  /** Number of missing frame numbers. */
  std::size_t
  gaps() const
  {
    return static_cast<std::size_t>(last_number) + 1 - frames;
  }
};

/** Records each frame and measures the time. */
class TimedRecorder {
public:
  TimedRecorder(const std::string& folder, const TrinocularRig& rig)
  : recorder_(folder, rig)
  {
    recorder_.setMostWaiting(max_waiting);
  }

  /** Called in the stream's thread. */
  void
  see(const TrinocularFrame& frame)
  {
    if (figures_.frames == frames_wanted)
      return;
    if (figures_.frames == 0)
      figures_.first_stamp = frame.stamp;
    else
      figures_.grabs.push_back(threadSeconds() - end_of_last_);
    figures_.waits.push_back(measureCost([&] { recorder_.record(frame); }).wall);
    end_of_last_ = threadSeconds();
    figures_.last_stamp = frame.stamp;
    figures_.last_number = frame.number;
    if (++figures_.frames == frames_wanted)
      done_.set_value();
  }

  /** Waits for all frames, with a long timeout. */
  void
  wait()
  {
    constexpr std::chrono::seconds patience(90);
    done_.get_future().wait_for(patience);
  }

  StreamFigures
  finish()
  {
    recorder_.finish();
    return figures_;
  }

private:
  TrinocularRecorder recorder_;
  StreamFigures figures_;
  double end_of_last_ = 0;
  std::promise<void> done_;
};

StreamFigures
record(const std::string& tiles)
{
  const auto shots = filmBytes(tiles);
  test::CameraOptions options;
  options.tiles = tiles;
  test::EmulatedIidcCamera camera(
      [&](const test::Exposure& exposure) {
        return shots[exposure.number % shots.size()];
      },
      options);
  test::UsbTestbed testbed;
  test::EmulatedUsbCamera cable(testbed, camera);
  const test::TemporaryFolder folder;

  DigiclopsGrabber grabber{TrinocularRig()};
  grabber.setFramesPerSecond(rate);
  TimedRecorder recorder(folder.path("session"), grabber.getRig());
  const std::function<TrinocularGrabber::FrameCallback> see =
      [&](const TrinocularFrame::ConstPtr& frame) { recorder.see(*frame); };
  grabber.registerCallback(see);
  const double begin = processSeconds();
  grabber.start();
  recorder.wait();
  grabber.stop();
  if (const std::exception_ptr error = grabber.getError())
    std::rethrow_exception(error);
  StreamFigures figures = recorder.finish();
  if (figures.frames < 2)
    throw std::runtime_error("no frames came");
  figures.process = processSeconds() - begin;
  figures.report = grabber.getReport();
  if (TrinocularFileGrabber(folder.path("session")).frames() != figures.frames)
    throw std::runtime_error("the session has not all frames");
  return figures;
}

void
printStream(const std::string& name, const std::string& tiles)
{
  const StreamFigures figures = record(tiles);
  const auto longest = [](const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
  };
  MarkdownRow()
      .text(name)
      .atLeast(static_cast<double>(figures.frames), frames_wanted, 0)
      .atMost(static_cast<double>(figures.report.lost), 0, 0)
      .atMost(static_cast<double>(figures.gaps()), 0, 0)
      .count(figures.report.broken)
      .atLeast(figures.rate(), 0.99 * static_cast<double>(rate), 2)
      .number(milli * median(figures.grabs), 1)
      .number(milli * median(figures.waits), 1)
      .number(milli * longest(figures.waits), 0)
      .number(milli * figures.process / static_cast<double>(figures.frames), 1)
      .print();
}

/** Can the USB devices that libusb sees be emulated? */
bool
hasEmulation()
{
  const char* const preloaded = std::getenv("LD_PRELOAD");
  return preloaded && std::strstr(preloaded, "umockdev");
}

} // namespace

void
printStream()
{
  if (!hasEmulation()) {
    std::cerr << "stream: left out, run by umockdev-wrapper\n";
    return;
  }
  printHead({"a minute at 14 frames a second",
             "frames",
             "lost, by the camera's counter",
             "missing numbers",
             "broken",
             "frames a second",
             "grab, CPU ms",
             "callback, ms",
             "longest callback, ms",
             "all with the emulated camera, CPU ms"});
  printStream("Bayer GBRG", "GBRG");
  printStream("grey", "YYYY");
}

} // namespace pcl::acmap::bench
