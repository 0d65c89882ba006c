#include "bench.h"
#include "bench_data.h"
#include "paper_patterns.h"
#include "run_tool.h"
#include "stereo_methods.h"
#include "temporary_folder.h"

#include <pcl/acquisition/pattern_selection.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/simulated_truth.h>
#include <pcl/simulation/standard_scenes.h>
#include <pcl/stereo/disparity_fusion.h>
#include <pcl/stereo/trinocular_matching.h>

#include <fstream>
#include <map>
#include <stdexcept>

namespace pcl::acmap::bench {
namespace {

constexpr double some_focal_length = 1000.0, some_baseline = 0.1;
constexpr double nearest = 0.5; // metres, default of the tool's --min-depth
constexpr int range_step = 16;

/** An image pair with the truth, and the pixels that both cameras see. */
struct TexturedPair {
  std::string name;
  std::string reference, neighbour; ///< files of the test data
  StereoShots shots;                ///< the images in grey
  PixelMask visible;
};

/** Truth and mask must be added. */
TexturedPair
loadPair(const std::string& name,
         const std::string& reference,
         const std::string& neighbour)
{
  CameraImage left = loadGreyImage(reference);
  TexturedPair pair{
      name,
      reference,
      neighbour,
      binocularShots(left.width, left.height, some_focal_length, some_baseline),
      {}};
  pair.shots.frames = {
      frameOf(std::move(left), loadGreyImage(neighbour), TrinocularFrame::no_pattern)};
  return pair;
}

/** The truth of the right view is the same surface; pixels without it are unknown. */
PixelMask
visibleByBothTruths(const DisparityImage& left, const DisparityImage& right)
{
  constexpr float same = 1.0f; // px
  PixelMask mask(left.values.size(), 0);
  for (int row = 0; row < left.height; ++row)
    for (int column = 0; column < left.width; ++column) {
      const float disparity = left.at(column, row);
      if (std::isnan(disparity))
        continue;
      const auto there = static_cast<int>(std::lround(column - disparity));
      if (there >= 0 && std::abs(right.at(there, row) - disparity) <= same)
        mask[static_cast<std::size_t>(row * left.width + column)] = 1;
    }
  return mask;
}

/** No part of the truth occludes the pixel's position in the right view. */
PixelMask
visibleByOneTruth(const DisparityImage& left)
{
  constexpr float same = 1.0f; // px
  PixelMask mask(left.values.size(), 0);
  for (int row = 0; row < left.height; ++row) {
    std::map<long, float> nearest; // by the column in the right view
    const auto nearestAt = [&](int column) -> float& {
      return nearest[std::lround(column - left.at(column, row))];
    };
    for (int column = 0; column < left.width; ++column)
      if (const float here = left.at(column, row); !std::isnan(here))
        nearestAt(column) = std::max(nearestAt(column), here);
    for (int column = 0; column < left.width; ++column)
      if (const float here = left.at(column, row);
          !std::isnan(here) && std::lround(column - here) >= 0)
        mask[static_cast<std::size_t>(row * left.width + column)] =
            here >= nearestAt(column) - same;
  }
  return mask;
}

/** \param steps stored units per px */
TexturedPair
loadBothTruths(const std::string& name,
               const std::string& left,
               const std::string& right,
               double steps)
{
  const std::string folder = "A_stereo/" + name + "/";
  const auto truthOf = [&](const std::string& image) {
    return loadPngDisparity(folder + "disp" + image.back() + ".png", steps);
  };
  TexturedPair pair = loadPair(name, folder + left + ".png", folder + right + ".png");
  pair.shots.truth = truthOf(left);
  pair.visible = visibleByBothTruths(pair.shots.truth, truthOf(right));
  return pair;
}

TexturedPair
loadMotorcycle()
{
  const std::string folder = "A_stereo/motorcycle/";
  TexturedPair pair = loadPair(
      "motorcycle", folder + "motorcycle_left.png", folder + "motorcycle_right.png");
  pair.shots.truth = loadPfm(pathOfData(folder + "disp_left.pfm").value());
  pair.visible = visibleByOneTruth(pair.shots.truth);
  return pair;
}

/** Search range that contains the truth. */
int
rangeOf(const DisparityImage& truth)
{
  float maximum = 0;
  for (const float disparity : truth.values)
    maximum = std::isnan(disparity) ? maximum : std::max(maximum, disparity);
  return (static_cast<int>(maximum) / range_step + 1) * range_step;
}

/** Runs the tool as a user does: on the image files, with its defaults. The rig is such
 * that the largest disparity of the range is at the minimum depth. */
DisparityErrors
errorsOf(const TexturedPair& pair)
{
  const test::TemporaryFolder folder;
  TrinocularRig rig = pair.shots.rig;
  rig.baseline_horizontal = nearest * rangeOf(pair.shots.truth) / rig.focal_length;
  saveTrinocularRig(folder.path("rig.yaml"), rig);
  test::runTool(ACMAP_ACTIVE_STEREO,
                {"--reference",
                 pathOfData(pair.reference).value(),
                 "--horizontal",
                 pathOfData(pair.neighbour).value(),
                 "--rig",
                 folder.path("rig.yaml"),
                 "-o",
                 folder.path("out")})
      .succeeded();
  DisparityErrors errors;
  errors.add(loadPfm(folder.path("out/disparity.pfm")), pair.shots.truth, pair.visible);
  return errors;
}

DisparityErrors
sgbmErrorsOf(const TexturedPair& pair, bool filters)
{
  constexpr double farthest = 10.0; // metres, default of the tool's --max-depth
  SgbmSetting setting;
  setting.disparities = rangeOf(pair.shots.truth);
  setting.minimum =
      std::max(static_cast<int>(setting.disparities * nearest / farthest) - 1, 0);
  setting.filters = filters;
  DisparityErrors errors;
  errors.add(sgbmDisparity(*pair.shots.frames.front(), pair.shots.rig, setting),
             pair.shots.truth,
             pair.visible);
  return errors;
}

void
printPair(const TexturedPair& pair)
{
  const DisparityErrors errors = errorsOf(pair);
  const DisparityErrors sgbm = sgbmErrorsOf(pair, true);
  Row() << pair.name << errors.judged() << atMost(errors.bad(), sgbm.bad(), 2)
        << figure(errors.wrong(), 2) << figure(errors.medianError(), 3)
        << figure(sgbm.bad(), 2) << figure(sgbm.wrong(), 2)
        << figure(sgbm.medianError(), 3) << figure(sgbmErrorsOf(pair, false).bad(), 2);
}

const Section middlebury_section("middlebury", [] {
  if (!pathOfData("A_stereo/Cones/im2.png"))
    return;
  printHead("one shot of texture | pixels both see | bad > 1 px or missing, % | of it "
            "wrong, % | median error, px | OpenCV SGBM: bad or missing, % | of it "
            "wrong, % | median error, px | without filters, bad or missing, %");
  constexpr double quarter = 4.0, third = 3.0; // stored units per px
  printPair(loadBothTruths("Cones", "im2", "im6", quarter));
  printPair(loadBothTruths("Teddy", "im2", "im6", quarter));
  printPair(loadBothTruths("Art", "view1", "view5", third));
  printPair(loadBothTruths("Moebius", "view1", "view5", third));
  printPair(loadMotorcycle());
});

constexpr char folder[] = "B_active/realsense_ir_on/";
constexpr char number[] = "_20200819_235924";
constexpr int width = 1280, height = 720;
constexpr double baseline = 0.05; // metres, from the camera's data sheet
constexpr int disparities = 128;

std::string
fileOf(const char* name, const char* ending)
{
  return std::string(folder) + name + number + ending;
}

/** Depths in millimetres, 0 for unknown; the file is a NumPy array of 16 bits. */
std::vector<std::uint16_t>
loadDepths()
{
  constexpr std::streamoff length_at = 8, header_at = 10; // format version 1
  std::ifstream file(pathOfData(fileOf("depth", ".npy")).value(), std::ios::binary);
  file.seekg(length_at);
  const int low = file.get();
  const int high = file.get();
  constexpr int byte = 256;
  file.seekg(header_at + low + byte * high);
  std::vector<std::uint16_t> depths(static_cast<std::size_t>(width * height));
  file.read(reinterpret_cast<char*>(depths.data()),
            static_cast<std::streamsize>(depths.size() * sizeof(depths[0])));
  if (!file)
    throw std::runtime_error("the depths of the factory's camera are cut off");
  return depths;
}

/** Disparity times depth, px mm, which replaces the unknown focal length. */
double
scaleOf(const DisparityImage& found, const std::vector<std::uint16_t>& depths)
{
  std::vector<double> products;
  for (std::size_t i = 0; i < depths.size(); ++i)
    if (depths[i] > 0 && !std::isnan(found.values[i]))
      products.push_back(depths[i] * static_cast<double>(found.values[i]));
  return median(products);
}

DisparityImage
disparitiesOf(const std::vector<std::uint16_t>& depths, double scale)
{
  DisparityImage image{width, height, {}};
  for (const std::uint16_t depth : depths)
    image.values.push_back(depth > 0 ? static_cast<float>(scale / depth)
                                     : std::numeric_limits<float>::quiet_NaN());
  return image;
}

void
printAgainst(const std::string& name,
             const DisparityImage& found,
             const std::vector<std::uint16_t>& depths)
{
  constexpr double metres_per_millimetre = 1e-3;
  const double scale = scaleOf(found, depths);
  const DisparityImage truth = disparitiesOf(depths, scale);
  DisparityErrors errors;
  errors.add(found, truth, pixelsWithTruth(truth));
  DisparityErrors all;
  all.add(found, found, PixelMask(found.values.size(), 1));
  Row() << name << errors.judged()
        << figure(scale * metres_per_millimetre / baseline, 1)
        << figure(errors.present() - errors.wrong(), 2) << figure(errors.wrong(), 2)
        << figure(errors.medianError(), 3) << figure(all.present(), 2);
}

const Section realsense_section("realsense", [] {
  if (!pathOfData(fileOf("depth", ".npy")))
    return;
  const std::vector<std::uint16_t> depths = loadDepths();
  StereoShots shots = binocularShots(width, height, some_focal_length, baseline);
  shots.frames = {frameOf(loadGreyImage(fileOf("left", ".png")),
                          loadGreyImage(fileOf("right", ".png")),
                          0)};
  TrinocularMatching matching;
  matching.setMaxDisparity(disparities);
  matching.setInputRig(shots.rig);
  MatchedDisparity masked, open;
  matching.match(*shots.frames.front(), masked);
  matching.setPeakFilter(0);
  matching.setCorrelationThreshold(-1);
  matching.match(*shots.frames.front(), open);
  printHead("dots of a factory's camera, against its own depth | pixels with its depth "
            "| focal length that fits, px | within 1 px, % | wrong, % | median "
            "difference, px | all pixels with a disparity, %");
  printAgainst("OpenCV SGBM",
               sgbmDisparity(*shots.frames.front(), shots.rig, {0, disparities}),
               depths);
  printAgainst("acmap, one shot", masked.disparity, depths);
  printAgainst("acmap, one shot, no thresholds", open.disparity, depths);
});

constexpr std::size_t views_of_scene = 3, all_patterns = 10;

/** Observations of some views, as patterns and errors. */
struct PatternFigures {
  DisparityErrors errors;
  std::size_t patterns = 0;
};

/** Lit pixels that a neighbour sees, within the search range. */
PixelMask
matchablePixels(const SimulatedTruth& truth)
{
  constexpr int neighbours =
      SimulatedTruth::in_horizontal | SimulatedTruth::in_vertical;
  constexpr float last = 63.0F; // px
  PixelMask mask = pixelsWithTruth(truth.horizontal);
  for (std::size_t i = 0; i < mask.size(); ++i)
    if ((truth.visible[i] & neighbours) == 0 ||
        (truth.visible[i] & SimulatedTruth::in_light) == 0 ||
        !(truth.horizontal.values[i] <= last))
      mask[i] = 0;
  return mask;
}

/** Matches the shots until the fusion wants no more, or the given number is reached. */
void
observeView(const SimulatedRigGrabber& grabber,
            std::size_t view,
            std::size_t patterns,
            bool early,
            const SimulatedTruth& truth,
            PatternFigures& figures)
{
  DisparityFusion fusion;
  fusion.setInputRig(grabber.getRig());
  std::size_t shown = 0;
  for (const TrinocularFrame::Ptr& frame : grabber.observe(view)) {
    fusion.addShot(frame);
    shown += frame->pattern != TrinocularFrame::no_pattern;
    if (shown == patterns || (early && shown > 0 && !fusion.wantsAnotherShot()))
      break;
  }
  MatchedDisparity fused;
  fusion.fuse(fused);
  figures.errors.add(fused.disparity, truth.horizontal, matchablePixels(truth));
  figures.patterns += shown;
}

/** Views of a scene under one sequence of patterns. */
class PatternViews {
public:
  PatternViews(const SimulatedScene& scene, const std::vector<RgbImage>& patterns)
  : grabber_(scene, patterns)
  {
    const std::size_t count = std::min(views_of_scene, scene.views.size());
    for (std::size_t i = 0; i < count; ++i) {
      views_.push_back(i * scene.views.size() / count);
      truths_.push_back(truthOf(scene, views_.back()));
    }
  }

  PatternFigures
  observe(std::size_t patterns, bool early) const
  {
    PatternFigures figures;
    for (std::size_t i = 0; i < views_.size(); ++i)
      observeView(grabber_, views_[i], patterns, early, truths_[i], figures);
    return figures;
  }

  /** The fewest patterns that leave no more pixels bad. */
  PatternFigures
  observeUntil(double bad) const
  {
    std::size_t patterns = 3;
    PatternFigures figures = observe(patterns, false);
    while (figures.errors.bad() > bad && patterns < all_patterns)
      figures = observe(++patterns, false);
    return figures;
  }

  double
  perObservation(const PatternFigures& figures) const
  {
    return static_cast<double>(figures.patterns) / static_cast<double>(views_.size());
  }

private:
  SimulatedRigGrabber grabber_;
  std::vector<std::size_t> views_;
  std::vector<SimulatedTruth> truths_;
};

void
printPatternScene(const std::string& name, const std::string& use)
{
  const SimulatedScene scene = standardScene(name);
  RandomLinePattern lines;
  const PatternViews random(scene, drawPatterns());
  const PatternViews selected(scene,
                              PatternSelection().selectFrom(lines, all_patterns));
  const auto print = [&](const std::string& way, const PatternFigures& figures) {
    Row() << name + use << way << figure(random.perObservation(figures), 1)
          << figure(figures.errors.bad(), 3) << figure(figures.errors.wrong(), 3)
          << figure(figures.errors.medianError(), 4);
  };
  const PatternFigures ten = random.observe(all_patterns, false);
  print("ten random", ten);
  print("random, early stop", random.observe(all_patterns, true));
  print("selected, early stop", selected.observe(all_patterns, true));
  print("selected, as few as leave no more bad",
        selected.observeUntil(ten.errors.bad()));
}

const Section patterns_section("patterns", [] {
  printHead("scene | patterns | per observation | bad > 1 px or missing, % | of it "
            "wrong, % | median error, px");
  printPatternScene("corridor", " (tuned)");
  for (const char* scene : {"office", "room"})
    printPatternScene(scene, "");
});

} // namespace
} // namespace pcl::acmap::bench
