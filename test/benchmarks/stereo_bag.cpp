#include "bench.h"
#include "bench_data.h"
#include "stereo_methods.h"
#include "stereo_shots.h"

#include <pcl/core/random.h>
#include <pcl/stereo/disparity_fusion.h>
#include <pcl/stereo/trinocular_matching.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::acmap::bench {
namespace {

constexpr char shots_folder[] = "B_active/bag_random_lines_N10/";
constexpr char code_folder[] = "B_active/graycode_bag_rect_half/";

TrinocularFrame::ConstPtr
loadPair(const std::string& folder, const std::string& number, std::int32_t pattern)
{
  return frameOf(loadGreyImage(folder + "L_" + number + ".png"),
                 loadGreyImage(folder + "R_" + number + ".png"),
                 pattern);
}

constexpr int bag_minimum = 48;     ///< px, start of the search range
constexpr int bag_disparities = 64; ///< px, size of the search range

/** A bag in front of a wall under ten patterns of random lines, seen by two cameras. The
 * images are computed from 46 real captures under Gray-code patterns, since light is
 * additive, and therefore have less noise than real shots. The truth, for half of the
 * pixels, is decoded from the same captures: +-0.25 px.
 * \return nothing, with a message, if the images are missing */
std::optional<StereoShots>
loadBag()
{
  constexpr double focal_length = 1851.6711, baseline = 0.0399255; // from its calib.txt
  const auto truth = pathOfData(std::string(code_folder) + "gt_disp_left.pfm");
  if (!truth || !pathOfData(std::string(shots_folder) + "R_09.png"))
    return std::nullopt;
  StereoShots bag = binocularShots(1024, 750, focal_length, baseline);
  for (int i = 0; i < 10; ++i)
    bag.frames.push_back(loadPair(shots_folder, "0" + std::to_string(i), i));
  bag.truth = loadPfm(*truth);
  return bag;
}

/** The matching, with the search range for the bag. */
TrinocularMatching
bagMatching()
{
  TrinocularMatching matching;
  matching.setXOffset(bag_minimum);
  matching.setMaxDisparity(bag_disparities);
  return matching;
}

/** A common setting, and the best one here. */
constexpr std::array<int, 2> sgbm_prefilters = {31, 63};

/** Targets for a method. */
struct BagTargets {
  double bad = no_reach;   // %
  double error = no_reach; // px, median
  double rms = no_reach;   // px
};

/** Errors of the disparities of several runs of a method. */
class MethodErrors {
public:
  explicit MethodErrors(const StereoShots& bag)
  : truth_(bag.truth)
  , mask_(pixelsWithTruth(bag.truth))
  {}

  void
  add(const DisparityImage& found)
  {
    all_.add(found, truth_, mask_);
    DisparityErrors one;
    one.add(found, truth_, mask_);
    max_bad_ = std::max(max_bad_, one.bad());
  }

  /** Percentage. */
  double
  bad() const
  {
    return all_.bad();
  }

  void
  print(const std::string& name, std::size_t shots, const BagTargets& reach = {}) const
  {
    constexpr int digits = 3;
    Row() << name << shots << atMost(all_.bad(), reach.bad, digits)
          << figure(max_bad_, digits) << figure(all_.wrong(), digits)
          << atMost(all_.medianError(), reach.error, digits)
          << atMost(all_.rms(), reach.rms, digits);
  }

private:
  const DisparityImage& truth_;
  PixelMask mask_;
  DisparityErrors all_;
  double max_bad_ = 0;
};

constexpr char titles[] = "method | shots | bad > 1 px or missing, % | of the worst, % "
                          "| of it wrong, % | median error, px | RMS of errors to 1 px";

void
printSgbm(const std::string& name,
          const StereoShots& bag,
          const std::vector<TrinocularFrame::ConstPtr>& frames,
          int prefilter)
{
  const std::vector<DisparityImage> images =
      sgbmDisparities(frames, bag.rig, {bag_minimum, bag_disparities, prefilter});
  MethodErrors single(bag);
  for (const DisparityImage& image : images)
    single.add(image);
  const std::string method =
      "OpenCV SGBM, prefilter " + std::to_string(prefilter) + ", ";
  single.print(method + name, 1);
  if (images.size() == 1)
    return;
  MethodErrors fused(bag);
  fused.add(medianDisparity(images));
  fused.print(method + "median", images.size());
}

/** Matches groups of this number of shots, until all have been used. */
void
printTogether(const StereoShots& bag, std::size_t shots, const BagTargets& reach)
{
  TrinocularMatching matching = bagMatching();
  matching.setInputRig(bag.rig);
  MethodErrors errors(bag);
  for (auto first = bag.frames.begin();
       static_cast<std::size_t>(bag.frames.end() - first) >= shots;
       first += static_cast<std::ptrdiff_t>(shots)) {
    MatchedDisparity matched;
    matching.match({first, first + static_cast<std::ptrdiff_t>(shots)}, matched);
    errors.add(matched.disparity);
  }
  errors.print(shots == 1 ? "acmap, one pattern" : "acmap, space-time", shots, reach);
}

void
printFused(const std::string& name,
           const StereoShots& bag,
           DisparityFusion::Method method,
           const BagTargets& reach)
{
  MethodErrors errors(bag);
  errors.add(fusedDisparity(bag, method, bagMatching()).disparity);
  errors.print("acmap, " + name, bag.frames.size(), reach);
}

/** Adds sensor noise to an image. */
CameraImage
noisy(CameraImage image, Random& random)
{
  constexpr double deviation = 4.0; // grey levels
  constexpr double brightest = 255.0;
  for (std::uint8_t& value : image.values)
    value = static_cast<std::uint8_t>(
        std::lround(std::clamp(value + deviation * random.normal(), 0.0, brightest)));
  return image;
}

const Section bag_section("bag", [] {
  const auto bag = loadBag();
  if (!bag)
    return;
  printHead(titles);
  for (const int prefilter : sgbm_prefilters) {
    // under white light of the projector
    const std::vector<TrinocularFrame::ConstPtr> passive{
        loadPair(code_folder, "44", 0)};
    printSgbm("projector white, no pattern", *bag, passive, prefilter);
    printSgbm("one pattern", *bag, bag->frames, prefilter);
  }
  printTogether(*bag, 1, {3.0, no_reach, no_reach});
  for (const std::size_t shots : {2U, 3U})
    printTogether(*bag, shots, {});
  printTogether(*bag, 5, {0.3, no_reach, no_reach});
  printTogether(*bag, 10, {0.15, 0.085, 0.14});
  printFused(
      "median", *bag, DisparityFusion::Method::Median, {1.3, no_reach, no_reach});
  printFused("statistical", *bag, DisparityFusion::Method::Statistical, {});
});

const Section noise_section("noise", [] {
  auto bag = loadBag();
  if (!bag)
    return;
  Random random(1);
  for (TrinocularFrame::ConstPtr& frame : bag->frames) {
    CameraImage reference = noisy(frame->image(RigCamera::Reference), random);
    CameraImage neighbour = noisy(frame->image(RigCamera::Horizontal), random);
    frame = frameOf(std::move(reference), std::move(neighbour), frame->pattern);
  }
  printHead(titles);
  for (const int prefilter : sgbm_prefilters)
    printSgbm("one pattern", *bag, bag->frames, prefilter);
  printTogether(*bag, 1, {});
  printTogether(*bag, 10, {0.3, no_reach, no_reach});
  printFused("median", *bag, DisparityFusion::Method::Median, {});
  printFused("statistical", *bag, DisparityFusion::Method::Statistical, {});
});

// The captures once more, under other patterns

/** What the two cameras saw of one Gray-code pattern. */
using CapturedPair = std::array<CameraImage, 2>;

constexpr std::size_t code_bits = 22; // eleven of columns, eleven of rows
constexpr std::size_t dark_capture = 45;

/** All captures; that of pattern 2 k is the negative of 2 k + 1, the last one is dark. */
std::optional<std::vector<CapturedPair>>
loadCaptures()
{
  std::vector<CapturedPair> captures;
  for (std::size_t i = 0; i <= dark_capture; ++i) {
    const std::string number = (i < 10 ? "0" : "") + std::to_string(i);
    if (!pathOfData(code_folder + ("R_" + number + ".png")))
      return std::nullopt;
    captures.push_back({loadGreyImage(code_folder + ("L_" + number + ".png")),
                        loadGreyImage(code_folder + ("R_" + number + ".png"))});
  }
  return captures;
}

/** A shot under a pattern that adds all codes with random weights: stripes of random
 * brightness along both axes. Light is additive. */
TrinocularFrame::ConstPtr
recombined(const std::vector<CapturedPair>& captures,
           std::int32_t pattern,
           Random& random)
{
  constexpr double contrast = 1.6; // of the sum of all weights; few of them decide
  std::array<double, 2 * code_bits> weights{};
  double total = 0;
  for (double& weight : weights)
    total += weight = std::pow(random.uniform(), 4);
  std::array<CameraImage, 2> images;
  for (std::size_t camera = 0; camera < images.size(); ++camera) {
    images[camera] = captures[dark_capture][camera];
    std::vector<double> light(images[camera].values.begin(),
                              images[camera].values.end());
    for (std::size_t code = 0; code < weights.size(); ++code)
      for (std::size_t i = 0; i < light.size(); ++i)
        light[i] += contrast * weights[code] / total *
                    (captures[code][camera].values[i] -
                     captures[dark_capture][camera].values[i]);
    std::transform(
        light.begin(), light.end(), images[camera].values.begin(), [](double grey) {
          return static_cast<std::uint8_t>(std::lround(std::clamp(grey, 0.0, 255.0)));
        });
  }
  return frameOf(std::move(images[0]), std::move(images[1]), pattern);
}

const Section recombined_section("recombined", [] {
  auto bag = loadBag();
  const auto captures = loadCaptures();
  if (!bag || !captures)
    return;
  constexpr std::uint64_t first_seed = 101, seeds = 20;
  using Method = DisparityFusion::Method;
  const std::array<std::pair<const char*, Method>, 3> methods = {
      {{"acmap, median", Method::Median},
       {"acmap, statistical", Method::Statistical},
       {"acmap, space-time", Method::SpaceTime}}};
  std::vector<MethodErrors> errors(methods.size(), MethodErrors(*bag));
  for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
    Random random(seed);
    for (std::size_t i = 0; i < bag->frames.size(); ++i)
      bag->frames[i] = recombined(*captures, static_cast<std::int32_t>(i), random);
    for (std::size_t i = 0; i < methods.size(); ++i)
      errors[i].add(fusedDisparity(*bag, methods[i].second, bagMatching()).disparity);
  }
  printHead(titles);
  const BagTargets reach = {0.9 * errors[0].bad(), no_reach, no_reach};
  for (std::size_t i = 0; i < methods.size(); ++i)
    errors[i].print(methods[i].first,
                    bag->frames.size(),
                    methods[i].second == Method::Statistical ? reach : BagTargets{});
});

} // namespace
} // namespace pcl::acmap::bench
