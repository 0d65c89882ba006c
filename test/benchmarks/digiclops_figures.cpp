#include "bench.h"
#include "frame_bytes.h"
#include "paper_patterns.h"
#include "stereo_shots.h"
#include "temporary_folder.h"
#include "usb_testbed.h"

#include <pcl/acquisition/channel_order.h>
#include <pcl/acquisition/digiclops_grabber.h>
#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/acquisition/trinocular_file_grabber.h>
#include <pcl/acquisition/trinocular_recorder.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/standard_scenes.h>

#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>
#include <future>
#include <stdexcept>

namespace pcl::acmap::bench {
namespace {

/** Results of the check for one kind of frames under all channel orders. What has no
 * order, or hardly one, is in the tests. */
class OrderFigures {
public:
  /** Permutes the channels in all ways, and checks each permutation. */
  void
  add(const TrinocularFrame& frame, const RigCalibration& cameras)
  {
    constexpr ChannelOrder assumed{
        RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical};
    ChannelOrder own = assumed;
    do {
      TrinocularFrame mixed = frame;
      for (std::size_t k = 0; k < own.size(); ++k)
        mixed.image(assumed[k]) = frame.image(own[k]);
      ChannelOrderCheck check;
      seconds_.push_back(
          measureThread([&] { check = checkChannelOrder(mixed, assumed, cameras); }));
      judge(check, own);
    } while (std::next_permutation(own.begin(), own.end()));
  }

  void
  print(const std::string& name) const
  {
    constexpr double reach = 500; // ms
    Row() << name << seconds_.size() << right_ << seconds_.size() - right_ - wrong_
          << atMost(wrong_, 0, 0) << figure(median(shares_), 2)
          << figure(median(found_), 0) << figure(largest(runners_up_), 2)
          << figure(milli * median(seconds_), 0)
          << atMost(milli * largest(seconds_), reach, 0);
  }

private:
  void
  judge(const ChannelOrderCheck& check, const ChannelOrder& own)
  {
    const bool is_right = check.best == own;
    right_ += check.is_certain && is_right ? 1 : 0;
    wrong_ += check.is_certain && !is_right ? 1 : 0;
    shares_.push_back(check.share);
    found_.push_back(check.share * static_cast<double>(check.corners));
    runners_up_.push_back(check.runner_up);
  }

  std::size_t right_ = 0;
  std::size_t wrong_ = 0;
  std::vector<double> seconds_, shares_, found_, runners_up_;
};

/** Simulates a scene with rectified cameras and with cameras as built. */
class Filming {
public:
  Filming(SimulatedScene scene, const std::vector<RgbImage>& patterns, double noise)
  : views_(scene.views.size())
  {
    SimulatedLight light;
    light.read_noise = noise;
    cameras_[0] = calibrationOf(scene.rig);
    grabbers_[0] = std::make_unique<SimulatedRigGrabber>(scene, patterns, light);
    scene.rig = loadTrinocularRig(ACMAP_BUILT_RIG);
    cameras_[1] = loadRigCalibration(ACMAP_BUILT_RIG);
    grabbers_[1] =
        std::make_unique<SimulatedRigGrabber>(scene, patterns, cameras_[1], light);
  }

  /** Simulates some evenly spaced views with both kinds of cameras. */
  void
  run(std::size_t views,
      const std::function<void(const TrinocularFrame&, const RigCalibration&)>& see)
      const
  {
    views = std::min(views, views_);
    for (std::size_t i = 0; i < views; ++i)
      for (std::size_t k = 0; k < cameras_.size(); ++k)
        for (const TrinocularFrame::Ptr& frame :
             grabbers_[k]->observe((2 * i + 1) * views_ / (2 * views)))
          see(*frame, cameras_[k]);
  }

private:
  std::size_t views_;
  std::array<RigCalibration, 2> cameras_;
  std::array<std::unique_ptr<SimulatedRigGrabber>, 2> grabbers_;
};

constexpr std::size_t views_of_scene = 8;
constexpr double usual_noise = 1.0; // grey levels, the default of SimulatedLight

/** Shots without a pattern and under a pattern. */
void
printScene(const std::string& name, const SimulatedScene& scene)
{
  OrderFigures plain, lit;
  Filming(scene, {RandomLinePattern().generate(1)}, usual_noise)
      .run(views_of_scene, [&](const auto& frame, const auto& cameras) {
        const bool is_plain = frame.pattern == TrinocularFrame::no_pattern;
        (is_plain ? plain : lit).add(frame, cameras);
      });
  lit.print(name + ", random lines");
  plain.print(name + ", no pattern");
}

/** Shots with more noise. */
void
printNoise(double noise)
{
  OrderFigures figures;
  for (const SimulatedScene& scene :
       {wallWithBox(), slantedWall(), standardScene("corridor")})
    Filming(scene, {RandomLinePattern().generate(1)}, noise)
        .run(3, [&](const auto& frame, const auto& cameras) {
          if (frame.pattern != TrinocularFrame::no_pattern)
            figures.add(frame, cameras);
        });
  figures.print("random lines, noise " + std::to_string(std::lround(noise)) +
                " grey levels");
}

const Section order_section("order", [] {
  printHead("frames | checks | certain and right | uncertain | certain and wrong | "
            "share of corners, median | corners found, median | share under another "
            "order, at most | median, CPU ms | longest, CPU ms");
  for (const std::string& name : standardSceneNames())
    printScene(name, standardScene(name));
  printScene("wall with a box", wallWithBox());
  printScene("slanted wall", slantedWall());
  printNoise(5);
  printNoise(15);
});

constexpr std::size_t frames_wanted = 840; // one minute
constexpr float rate = 14;                 // as in the paper
constexpr std::size_t max_waiting = 28;    // two seconds

/** Bytes of shots in the format of the camera. */
std::vector<std::vector<std::uint8_t>>
filmBytes(const std::string& tiles)
{
  const SimulatedRigGrabber grabber(standardScene("corridor"), drawPatterns());
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
  Row() << name << atLeast(figures.frames, frames_wanted, 0)
        << atMost(figures.report.lost, 0, 0) << atMost(figures.gaps(), 0, 0)
        << figures.report.broken
        << atLeast(figures.rate(), 0.99 * static_cast<double>(rate), 2)
        << figure(milli * median(figures.grabs), 1)
        << figure(milli * median(figures.waits), 1)
        << figure(milli * largest(figures.waits), 0)
        << figure(milli * figures.process / static_cast<double>(figures.frames), 1);
}

/** Can the USB devices that libusb sees be emulated? */
bool
hasEmulation()
{
  const char* const preloaded = std::getenv("LD_PRELOAD");
  return preloaded && std::strstr(preloaded, "umockdev");
}

const Section stream_section("stream", [] {
  if (!hasEmulation()) {
    std::cerr << "stream: left out, run by umockdev-wrapper\n";
    return;
  }
  printHead("a minute at 14 frames a second | frames | lost, by the camera's counter | "
            "missing numbers | broken | frames a second | grab, CPU ms | callback, ms "
            "| longest callback, ms | all with the emulated camera, CPU ms");
  printStream("Bayer GBRG", "GBRG");
  printStream("grey", "YYYY");
});

} // namespace
} // namespace pcl::acmap::bench
