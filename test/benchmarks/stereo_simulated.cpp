#include "disparity_errors.h"
#include "markdown_row.h"
#include "sgbm_disparity.h"
#include "simulated_shots.h"
#include "stereo_tables.h"
#include "units.h"
#include "wall_fit.h"

#include <pcl/stereo/disparity_fusion.h>

#include <algorithm>
#include <functional>

namespace pcl::acmap::bench {
namespace {

/** Targets for a method on pixels that can be matched. */
struct SimulatedTargets {
  double bad = no_reach;     // %
  double error = no_reach;   // px, median
  double locking = no_reach; // px
  double astray = no_reach;  // %, of the pixels that cannot be matched
};

/** Statistics of a method over several views. */
struct MethodFigures {
  DisparityErrors matchable; // lit, and seen by a neighbour
  DisparityErrors unlit;
  DisparityErrors unseen; // lit, seen by no neighbour, of one surface
  FractionErrors fractions;
  SigmaErrors sigmas;
  std::vector<WallFit> walls;
};

using Method = std::function<MatchedDisparity(const StereoShots&)>;

PixelMask
pixelsWhere(const SimulatedTruth& truth,
            const std::function<bool(bool seen, bool lit)>& wanted,
            bool three_views)
{
  const int seen =
      SimulatedTruth::in_horizontal | (three_views ? SimulatedTruth::in_vertical : 0);
  PixelMask mask = pixelsWithTruth(truth.horizontal);
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (!wanted((truth.visible[i] & seen) != 0,
                (truth.visible[i] & SimulatedTruth::in_light) != 0))
      mask[i] = 0;
  return mask;
}

/** Removes pixels beside another surface, which show a mixture of both. */
PixelMask
withoutMixed(PixelMask mask, const SimulatedTruth& truth)
{
  const int width = truth.horizontal.width, height = truth.horizontal.height;
  const auto surfaceAt = [&](int column, int row) {
    return truth.surfaces[static_cast<std::size_t>(
        std::clamp(row, 0, height - 1) * width + std::clamp(column, 0, width - 1))];
  };
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          if (surfaceAt(column + dx, row + dy) != surfaceAt(column, row))
            mask[static_cast<std::size_t>(row * width + column)] = 0;
  return mask;
}

void
judge(const MatchedDisparity& found,
      const SimulatedTruth& truth,
      const TrinocularRig& rig,
      MethodFigures& figures)
{
  const bool three_views = rig.baseline_vertical != 0;
  const DisparityImage& exact = truth.horizontal;
  const PixelMask matchable = pixelsWhere(
      truth, [](bool seen, bool lit) { return seen && lit; }, three_views);
  figures.matchable.add(found.disparity, exact, matchable);
  figures.fractions.add(found.disparity, exact, matchable);
  figures.unlit.add(found.disparity,
                    exact,
                    pixelsWhere(
                        truth, [](bool, bool lit) { return !lit; }, three_views));
  const PixelMask unseen = pixelsWhere(
      truth, [](bool seen, bool lit) { return !seen && lit; }, three_views);
  figures.unseen.add(found.disparity, exact, withoutMixed(unseen, truth));
  if (found.sigma.empty())
    return;
  figures.sigmas.add(found.disparity, found.sigma, exact, matchable);
  figures.walls.push_back(fitWall(found, truth, matchable, rig));
}

MethodFigures
figuresOf(const std::vector<SimulatedShots>& views,
          bool three_views,
          const Method& method)
{
  MethodFigures figures;
  for (const SimulatedShots& view : views) {
    const StereoShots shots = three_views ? view.shots : withoutVertical(view.shots);
    judge(method(shots), view.truth, shots.rig, figures);
  }
  return figures;
}

MatchedDisparity
onePattern(const StereoShots& shots)
{
  TrinocularMatching matching;
  matching.setInputRig(shots.rig);
  MatchedDisparity matched;
  matching.match(*shots.frames.front(), matched);
  return matched;
}

Method
fusedBy(DisparityFusion::Method method)
{
  return [method](const StereoShots& shots) {
    DisparityFusion fusion;
    fusion.setMethod(method);
    fusion.setInputRig(shots.rig);
    for (const TrinocularFrame::ConstPtr& frame : shots.frames)
      fusion.addShot(frame);
    MatchedDisparity fused;
    fusion.fuse(fused);
    return fused;
  };
}

MatchedDisparity
sgbmOne(const StereoShots& shots)
{
  return {sgbmDisparity(*shots.frames.front(), shots.rig, {}), {}, {}, {}};
}

MatchedDisparity
sgbmMedian(const StereoShots& shots)
{
  return {medianDisparity(sgbmDisparities(shots.frames, shots.rig, {})), {}, {}, {}};
}

struct NamedFigures {
  std::string name;
  MethodFigures figures;
  SimulatedTargets reach;
};

std::vector<NamedFigures>
measureMethods(const std::vector<SimulatedShots>& views)
{
  const auto spacetime = fusedBy(DisparityFusion::Method::SpaceTime);
  const SimulatedTargets of_two{0.3, 0.02, 0.01, 5.0};
  const SimulatedTargets of_three{0.2, 0.015, 0.01, 5.0};
  std::vector<NamedFigures> all;
  const auto add = [&](const std::string& name,
                       bool three_views,
                       const Method& method,
                       const SimulatedTargets& reach = {}) {
    all.push_back({name, figuresOf(views, three_views, method), reach});
  };
  add("OpenCV SGBM, one pattern, two views", false, sgbmOne);
  add("OpenCV SGBM, median, two views", false, sgbmMedian);
  for (const bool three : {false, true}) {
    const std::string end = three ? ", three views" : ", two views";
    add("acmap, one pattern" + end, three, onePattern);
    add("acmap, median" + end, three, fusedBy(DisparityFusion::Method::Median));
    add("acmap, statistical" + end,
        three,
        fusedBy(DisparityFusion::Method::Statistical));
    add("acmap, space-time" + end, three, spacetime, three ? of_three : of_two);
  }
  return all;
}

void
printErrors(const std::vector<NamedFigures>& all)
{
  printHead({"lit pixels that a neighbour sees",
             "pixels",
             "bad > 1 px or missing, %",
             "of it wrong, %",
             "median error, px",
             "RMS of errors to 1 px",
             "locking of means, px",
             "of medians, px"});
  for (const NamedFigures& one : all) {
    const DisparityErrors& errors = one.figures.matchable;
    MarkdownRow()
        .text(one.name)
        .count(errors.judged())
        .atMost(errors.bad(), one.reach.bad, 3)
        .number(errors.wrong(), 3)
        .atMost(errors.medianError(), one.reach.error, 4)
        .number(errors.rms(), 4)
        .atMost(one.figures.fractions.lockingOfMeans(), one.reach.locking, 4)
        .atMost(one.figures.fractions.lockingOfMedians(), one.reach.locking, 4)
        .print();
  }
}

void
printAstray(const std::vector<NamedFigures>& all)
{
  printHead({"pixels that cannot be matched",
             "unlit",
             "wrong there, %",
             "a disparity there, %",
             "lit but hidden",
             "wrong there, %",
             "a disparity there, %"});
  for (const NamedFigures& one : all)
    MarkdownRow()
        .text(one.name)
        .count(one.figures.unlit.judged())
        .atMost(one.figures.unlit.wrong(), one.reach.astray, 2)
        .number(one.figures.unlit.present(), 2)
        .count(one.figures.unseen.judged())
        .atMost(one.figures.unseen.wrong(), one.reach.astray, 2)
        .number(one.figures.unseen.present(), 2)
        .print();
}

void
printSigmas(const std::vector<NamedFigures>& all)
{
  constexpr double honest = 0.3; // maximum deviation from 1
  printHead({"standard deviations",
             "RMS of error / sigma, less 1",
             "mean sigma, px",
             "RMS of errors, px",
             "wall: RMS off the fitted plane, mm",
             "the same by sigma, mm",
             "fitted plane off the true one, mm",
             "turned, mrad"});
  for (const NamedFigures& one : all) {
    if (one.figures.walls.empty())
      continue;
    const WallFit wall = meanOf(one.figures.walls);
    MarkdownRow()
        .text(one.name)
        .within(one.figures.sigmas.ratio() - 1, honest, 3)
        .number(one.figures.sigmas.meanSigma(), 4)
        .number(one.figures.matchable.rms(), 4)
        .number(milli * wall.rms, 2)
        .number(milli * wall.expected, 2)
        .number(milli * wall.offset, 2)
        .number(milli * wall.turn, 2)
        .print();
  }
}

} // namespace

void
printSimulated()
{
  const SimulatedScene scene = wallWithBox();
  std::vector<SimulatedShots> views;
  for (std::size_t view = 0; view < scene.views.size(); ++view)
    views.push_back(takeShots(scene, view));
  const std::vector<NamedFigures> all = measureMethods(views);
  printErrors(all);
  printAstray(all);
  printSigmas(all);
}

void
printSubpixel()
{
  const std::vector<SimulatedShots> views = {takeShots(slantedWall(), 0)};
  const auto spacetime = fusedBy(DisparityFusion::Method::SpaceTime);
  const MethodFigures sgbm = figuresOf(views, false, sgbmMedian);
  const MethodFigures median =
      figuresOf(views, false, fusedBy(DisparityFusion::Method::Median));
  const MethodFigures two = figuresOf(views, false, spacetime);
  const MethodFigures three = figuresOf(views, true, spacetime);
  printHead({"fraction of the true disparity, from",
             "OpenCV SGBM, median: mean error, px",
             "acmap, median, two views",
             "acmap, space-time, two views",
             "acmap, space-time, three views"});
  for (std::size_t bin = 0; bin < FractionErrors::bins; ++bin) {
    MarkdownRow row;
    row.number(static_cast<double>(bin) / FractionErrors::bins, 2);
    for (const MethodFigures* figures : {&sgbm, &median, &two, &three})
      row.number(figures->fractions.meanOf(bin), 4);
    row.print();
  }
}

} // namespace pcl::acmap::bench
