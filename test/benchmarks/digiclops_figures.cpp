#include "bench.h"
#include "frame_bytes.h"
#include "images/frame_unpacking.h"
#include "paper_patterns.h"
#include "stereo_shots.h"
#include "temporary_folder.h"
#include "usb_testbed.h"

#include <pcl/acquisition/channel_order.h>
#include <pcl/acquisition/digiclops_grabber.h>
#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/acquisition/trinocular_file_grabber.h>
#include <pcl/acquisition/trinocular_recorder.h>
#include <pcl/core/random.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/standard_scenes.h>
#include <pcl/stereo/trinocular_rectification.h>

#include <opencv2/imgproc.hpp>

#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>
#include <future>
#include <stdexcept>

namespace pcl::acmap::bench {
namespace {

constexpr std::size_t rounds = 100;

/** Rectification of a camera with OpenCV. */
class CameraRemap {
public:
  CameraRemap(const TrinocularRectification& rectification,
              const CameraCalibration& camera,
              RigCamera which)
  {
    const TrinocularRig& rig = rectification.getRig();
    const Eigen::Matrix3d R_camera_common =
        rectification.getRotation(which).transpose();
    cv::Mat_<float> columns(rig.height, rig.width), rows(rig.height, rig.width);
    for (int y = 0; y < rig.height; ++y)
      for (int x = 0; x < rig.width; ++x) {
        const Eigen::Vector3d ray((x - rig.center_x) / rig.focal_length,
                                  (y - rig.center_y) / rig.focal_length,
                                  1.0);
        const Eigen::Vector2d from = projectPoint(camera, R_camera_common * ray);
        columns(y, x) = static_cast<float>(from.x());
        rows(y, x) = static_cast<float>(from.y());
      }
    cv::convertMaps(columns, rows, places_, weights_, CV_16SC2);
  }

  void
  run(CameraImage& image, cv::Mat& remapped) const
  {
    const cv::Mat from(
        image.height, image.width, CV_8UC(image.channels), image.values.data());
    cv::remap(
        from, remapped, places_, weights_, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  }

private:
  cv::Mat places_;
  cv::Mat weights_;
};

/** Checks that both methods give the same images. */
void
requireAlike(const CameraImage& ours, const cv::Mat& theirs)
{
  constexpr double maximum =
      4; // mean difference on noise, in grey levels: cv::remap has
         // steps of 1/32 px
  double sum = 0;
  for (std::size_t i = 0; i < ours.values.size(); ++i)
    sum += std::abs(int{ours.values[i]} - int{theirs.data[i]});
  if (sum > maximum * static_cast<double>(ours.values.size()))
    throw std::runtime_error("cv::remap gives other images");
}

struct ConversionCosts {
  std::vector<double> unpack, rectify, both, remap_grey, remap_color;
};

class Conversion {
public:
  Conversion()
  : cameras_(loadRigCalibration(ACMAP_BUILT_RIG))
  , bytes_(std::size_t{3} * 640 * 480)
  {
    Random random(1);
    for (std::uint8_t& byte : bytes_)
      byte = static_cast<std::uint8_t>(random.bits());
    rectification_.setNumberOfThreads(1);
    rectification_.setInputCalibration(cameras_);
    for (std::size_t i = 0; i < 3; ++i)
      remaps_.emplace_back(
          rectification_, cameras_.cameras[i], static_cast<RigCamera>(i));
    for (const BayerPattern bayer : {BayerPattern::None, BayerPattern::Gbrg})
      unpackFrame(
          bytes_, layoutOf(bayer), bayer == BayerPattern::None ? grey_ : color_);
  }

  ConversionCosts
  measure(BayerPattern bayer)
  {
    ConversionCosts costs;
    TrinocularFrame frame, rectified;
    for (std::size_t round = 0; round < rounds; ++round) {
      costs.unpack.push_back(
          measureThread([&] { unpackFrame(bytes_, layoutOf(bayer), frame); }));
      costs.rectify.push_back(
          measureThread([&] { rectification_.rectify(frame, rectified); }));
      costs.both.push_back(costs.unpack.back() + costs.rectify.back());
      costs.remap_grey.push_back(measureThread([&] { remap(grey_); }));
      costs.remap_color.push_back(measureThread([&] { remap(color_); }));
    }
    remap(frame);
    for (std::size_t i = 0; i < 3; ++i)
      requireAlike(rectified.images[i], remapped_[i]);
    return costs;
  }

private:
  static PlaneLayout
  layoutOf(BayerPattern bayer)
  {
    PlaneLayout layout;
    layout.width = 640;
    layout.height = 480;
    layout.bayer = bayer;
    return layout;
  }

  void
  remap(TrinocularFrame& frame)
  {
    for (std::size_t i = 0; i < 3; ++i)
      remaps_[i].run(frame.images[i], remapped_[i]);
  }

  RigCalibration cameras_;
  std::vector<std::uint8_t> bytes_;
  TrinocularRectification rectification_;
  std::vector<CameraRemap> remaps_;
  TrinocularFrame grey_, color_;
  std::array<cv::Mat, 3> remapped_;
};

void
printCosts(const std::string& name, const ConversionCosts& costs)
{
  constexpr double reach = 4; // multiple of three grey images
  const auto row = [&](const std::string& kind, const auto& of) {
    Row() << name + ", " + kind << figure(milli * of(costs.unpack), 2)
          << figure(milli * of(costs.rectify), 2) << figure(milli * of(costs.both), 2)
          << figure(milli * of(costs.remap_grey), 2)
          << atMost(of(costs.both) / of(costs.remap_grey), reach, 2)
          << figure(milli * of(costs.remap_color), 2)
          << figure(of(costs.both) / of(costs.remap_color), 2);
  };
  row("median", median);
  row("least", [](const auto& values) { return quantile(values, 0); });
}

const Section conversion_section("conversion", [] {
  printHead(
      "three planes of 640 × 480 | take apart, ms | rectify, ms | both, ms | remap of "
      "three grey images, ms | of it | remap of three colour images, ms | of it");
  const int before = cv::getNumThreads();
  cv::setNumThreads(1);
  Conversion conversion;
  printCosts("grey", conversion.measure(BayerPattern::None));
  printCosts("Bayer GBRG", conversion.measure(BayerPattern::Gbrg));
  cv::setNumThreads(before);
});

/** Results of the check for one kind of frames under all channel orders. */
class OrderFigures {
public:
  /** \param[in] has_order is there a correct answer? */
  explicit OrderFigures(bool has_order = true)
  : has_order_(has_order)
  {}

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
    const bool is_right = has_order_ && check.best == own;
    right_ += check.is_certain && is_right ? 1 : 0;
    wrong_ += check.is_certain && !is_right ? 1 : 0;
    shares_.push_back(check.share);
    found_.push_back(check.share * static_cast<double>(check.corners));
    runners_up_.push_back(check.runner_up);
  }

  bool has_order_;
  std::size_t right_ = 0;
  std::size_t wrong_ = 0;
  std::vector<double> seconds_, shares_, found_, runners_up_;
};

RgbImage
squares(const SimulatedProjector& projector)
{
  constexpr int side = 16; // px
  RgbImage image{projector.width, projector.height, {}};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      image.values.insert(
          image.values.end(), 3, (x / side + y / side) % 2 == 0 ? 255 : 0);
  return image;
}

/** Equal vertical stripes. */
RgbImage
stripes(const SimulatedProjector& projector)
{
  constexpr int period = 24; // px
  RgbImage image{projector.width, projector.height, {}};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      image.values.insert(image.values.end(), 3, x % period < 6 ? 255 : 0);
  return image;
}

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

/** Shots under another kind of pattern, or with more noise. */
void
printPattern(const std::string& name, const RgbImage& pattern, double noise)
{
  OrderFigures figures;
  for (const SimulatedScene& scene :
       {wallWithBox(), slantedWall(), standardScene("corridor")})
    Filming(scene, {pattern}, noise)
        .run(3, [&](const auto& frame, const auto& cameras) {
          if (frame.pattern != TrinocularFrame::no_pattern)
            figures.add(frame, cameras);
        });
  figures.print(name);
}

/** Corrupted shots for which there is no correct answer. */
void
printBroken(const std::string& name,
            const std::function<void(TrinocularFrame&, std::size_t)>& spoil)
{
  OrderFigures figures(false);
  for (const char* const scene : {"office", "corridor"})
    Filming(standardScene(scene), {RandomLinePattern().generate(2)}, usual_noise)
        .run(2, [&](const auto& frame, const auto& cameras) {
          if (frame.pattern == TrinocularFrame::no_pattern)
            return;
          for (std::size_t camera = 0; camera < frame.images.size(); ++camera) {
            TrinocularFrame spoilt = frame;
            spoil(spoilt, camera);
            figures.add(spoilt, cameras);
          }
        });
  figures.print(name);
}

void
makeNoise(TrinocularFrame& frame)
{
  Random random(5);
  for (CameraImage& image : frame.images)
    for (std::uint8_t& value : image.values)
      value = static_cast<std::uint8_t>(random.bits());
}

const Section order_section("order", [] {
  printHead("frames | checks | certain and right | uncertain | certain and wrong | "
            "share of corners, median | corners found, median | share under another "
            "order, at most | median, CPU ms | longest, CPU ms");
  for (const std::string& name : standardSceneNames())
    printScene(name, standardScene(name));
  printScene("wall with a box", wallWithBox());
  printScene("slanted wall", slantedWall());
  const SimulatedProjector projector;
  const RgbImage lines = RandomLinePattern().generate(1);
  printPattern("random lines, noise 5 grey levels", lines, 5);
  printPattern("random lines, noise 15 grey levels", lines, 15);
  printPattern("squares that repeat", squares(projector), usual_noise);
  printPattern("upright lines that repeat", stripes(projector), usual_noise);
  printBroken("one camera dark", [](TrinocularFrame& frame, std::size_t camera) {
    std::vector<std::uint8_t>& values = frame.images[camera].values;
    std::fill(values.begin(), values.end(), 0);
  });
  printBroken("two cameras with one image",
              [](TrinocularFrame& frame, std::size_t camera) {
                frame.images[camera] = frame.images[(camera + 1) % 3];
              });
  printBroken("three cameras with one image",
              [](TrinocularFrame& frame, std::size_t camera) {
                const CameraImage image = frame.images[camera];
                frame.images.fill(image);
              });
  printBroken("noise alone",
              [](TrinocularFrame& frame, std::size_t) { makeNoise(frame); });
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
