#include "disparity_errors.h"
#include "markdown_row.h"
#include "run_tool.h"
#include "sgbm_disparity.h"
#include "stereo_tables.h"
#include "temporary_folder.h"
#include "test_data.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace pcl::acmap::bench {
namespace {

constexpr double some_focal_length = 1000.0, some_baseline = 0.1; // the sign is used
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
    std::vector<float> nearest(static_cast<std::size_t>(left.width), 0.0f);
    const auto nearestAt = [&](int column) -> float* {
      const auto there = static_cast<int>(std::lround(column - left.at(column, row)));
      return there >= 0 ? &nearest[static_cast<std::size_t>(there)] : nullptr;
    };
    const auto forEachTruth = [&](const auto& function) {
      for (int column = 0; column < left.width; ++column)
        if (!std::isnan(left.at(column, row)))
          if (float* there = nearestAt(column))
            function(column, *there);
    };
    forEachTruth([&](int column, float& there) {
      there = std::max(there, left.at(column, row));
    });
    forEachTruth([&](int column, float& there) {
      if (left.at(column, row) >= there - same)
        mask[static_cast<std::size_t>(row * left.width + column)] = 1;
    });
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
  pair.shots.truth = loadPfm(test::testDataPath(folder + "disp_left.pfm").string());
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

/** Minimum disparity that the tool searches if the maximum is at the minimum depth. */
int
leastOf(int range)
{
  constexpr double farthest = 10.0; // metres, default of the tool's --max-depth
  return std::max(static_cast<int>(range * nearest / farthest) - 1, 0);
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
  const test::ToolRun run = test::runTool(ACMAP_ACTIVE_STEREO,
                                          {"--reference",
                                           test::testDataPath(pair.reference).string(),
                                           "--horizontal",
                                           test::testDataPath(pair.neighbour).string(),
                                           "--rig",
                                           folder.path("rig.yaml"),
                                           "-o",
                                           folder.path("out")});
  if (run.exit_code != 0)
    throw std::runtime_error(run.err);
  DisparityErrors errors;
  errors.add(loadPfm(folder.path("out/disparity.pfm")), pair.shots.truth, pair.visible);
  return errors;
}

DisparityErrors
sgbmErrorsOf(const TexturedPair& pair, bool filters)
{
  SgbmSetting setting;
  setting.disparities = rangeOf(pair.shots.truth);
  setting.minimum = leastOf(setting.disparities);
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
  MarkdownRow()
      .text(pair.name)
      .count(errors.judged())
      .atMost(errors.bad(), sgbm.bad(), 2)
      .number(errors.wrong(), 2)
      .number(errors.medianError(), 3)
      .number(sgbm.bad(), 2)
      .number(sgbm.wrong(), 2)
      .number(sgbm.medianError(), 3)
      .number(sgbmErrorsOf(pair, false).bad(), 2)
      .print();
}

} // namespace

void
printMiddlebury()
{
  if (!hasAllData("middlebury",
                  {"A_stereo/Cones/im2.png",
                   "A_stereo/Teddy/im2.png",
                   "A_stereo/Art/view1.png",
                   "A_stereo/Moebius/view1.png",
                   "A_stereo/motorcycle/disp_left.pfm"}))
    return;
  printHead({"one shot of texture",
             "pixels both see",
             "bad > 1 px or missing, %",
             "of it wrong, %",
             "median error, px",
             "OpenCV SGBM: bad or missing, %",
             "of it wrong, %",
             "median error, px",
             "without filters, bad or missing, %"});
  constexpr double quarter = 4.0, third = 3.0; // stored units per px
  printPair(loadBothTruths("Cones", "im2", "im6", quarter));
  printPair(loadBothTruths("Teddy", "im2", "im6", quarter));
  printPair(loadBothTruths("Art", "view1", "view5", third));
  printPair(loadBothTruths("Moebius", "view1", "view5", third));
  printPair(loadMotorcycle());
}

} // namespace pcl::acmap::bench
