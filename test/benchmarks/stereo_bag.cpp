#include "stereo_bag.h"
#include "disparity_errors.h"
#include "markdown_row.h"
#include "sgbm_disparity.h"
#include "stereo_tables.h"

#include <pcl/core/random.h>
#include <pcl/stereo/disparity_fusion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl::acmap::bench {
namespace {

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

  void
  print(const std::string& name, std::size_t shots, const BagTargets& reach = {}) const
  {
    constexpr int digits = 3;
    MarkdownRow()
        .text(name)
        .count(shots)
        .atMost(all_.bad(), reach.bad, digits)
        .number(max_bad_, digits)
        .number(all_.wrong(), digits)
        .atMost(all_.medianError(), reach.error, digits)
        .atMost(all_.rms(), reach.rms, digits)
        .print();
  }

private:
  const DisparityImage& truth_;
  PixelMask mask_;
  DisparityErrors all_;
  double max_bad_ = 0;
};

void
printMethodHead()
{
  printHead({"method",
             "shots",
             "bad > 1 px or missing, %",
             "of the worst, %",
             "of it wrong, %",
             "median error, px",
             "RMS of errors to 1 px"});
}

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
  DisparityFusion fusion;
  fusion.setMatching(bagMatching());
  fusion.setMethod(method);
  fusion.setInputRig(bag.rig);
  for (const TrinocularFrame::ConstPtr& frame : bag.frames)
    fusion.addShot(frame);
  MatchedDisparity fused;
  fusion.fuse(fused);
  MethodErrors errors(bag);
  errors.add(fused.disparity);
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

void
addNoise(StereoShots& bag)
{
  Random random(1);
  for (TrinocularFrame::ConstPtr& frame : bag.frames) {
    CameraImage reference = noisy(frame->image(RigCamera::Reference), random);
    CameraImage neighbour = noisy(frame->image(RigCamera::Horizontal), random);
    frame = frameOf(std::move(reference), std::move(neighbour), frame->pattern);
  }
}

} // namespace

void
printBag()
{
  if (!hasBag("bag"))
    return;
  const StereoShots bag = loadBag();
  printMethodHead();
  for (const int prefilter : sgbm_prefilters) {
    printSgbm("projector white, no pattern", bag, {loadPassiveBag()}, prefilter);
    printSgbm("one pattern", bag, bag.frames, prefilter);
  }
  printTogether(bag, 1, {3.0, no_reach, no_reach});
  for (const std::size_t shots : {2U, 3U})
    printTogether(bag, shots, {});
  printTogether(bag, 5, {0.3, no_reach, no_reach});
  printTogether(bag, 10, {0.15, 0.085, 0.14});
  printFused("median", bag, DisparityFusion::Method::Median, {1.3, no_reach, no_reach});
  printFused("statistical", bag, DisparityFusion::Method::Statistical, {});
}

void
printNoise()
{
  if (!hasBag("noise"))
    return;
  StereoShots bag = loadBag();
  addNoise(bag);
  printMethodHead();
  for (const int prefilter : sgbm_prefilters)
    printSgbm("one pattern", bag, bag.frames, prefilter);
  printTogether(bag, 1, {});
  printTogether(bag, 10, {0.3, no_reach, no_reach});
  printFused("median", bag, DisparityFusion::Method::Median, {});
  printFused("statistical", bag, DisparityFusion::Method::Statistical, {});
}

} // namespace pcl::acmap::bench
