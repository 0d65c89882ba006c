#include "digiclops_tables.h"
#include "markdown_row.h"
#include "simulated_shots.h"
#include "timing.h"
#include "units.h"

#include <pcl/acquisition/channel_order.h>
#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/core/random.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/standard_scenes.h>

#include <algorithm>
#include <functional>

namespace pcl::acmap::bench {

namespace {

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
    MarkdownRow()
        .text(name)
        .count(seconds_.size())
        .count(right_)
        .count(seconds_.size() - right_ - wrong_)
        .atMost(static_cast<double>(wrong_), 0, 0)
        .number(median(shares_), 2)
        .number(median(found_), 0)
        .number(*std::max_element(runners_up_.begin(), runners_up_.end()), 2)
        .number(milli * median(seconds_), 0)
        .atMost(milli * *std::max_element(seconds_.begin(), seconds_.end()), reach, 0)
        .print();
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

} // namespace

void
printOrder()
{
  printHead({"frames",
             "checks",
             "certain and right",
             "uncertain",
             "certain and wrong",
             "share of corners, median",
             "corners found, median",
             "share under another order, at most",
             "median, CPU ms",
             "longest, CPU ms"});
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
}

} // namespace pcl::acmap::bench
