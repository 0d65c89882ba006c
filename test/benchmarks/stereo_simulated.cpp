#include "bench.h"
#include "stereo_methods.h"
#include "stereo_shots.h"

#include <pcl/core/impl/moments.h>
#include <pcl/simulation/simulated_truth.h>
#include <pcl/stereo/disparity_fusion.h>
#include <pcl/stereo/matched_disparity.h>

#include <opencv2/core/utility.hpp>

#include <functional>

namespace pcl::acmap::bench {
namespace {

/** \brief Statistics of a plane fit to the points of a wall. */
struct WallFit {
  double rms = 0;      ///< metres, distances of the points from the plane
  double expected = 0; ///< metres, the value expected from the standard deviations
  double offset = 0;   ///< metres, distance from the true plane at the centroid of the
                       ///< points
  double turn = 0;     ///< rad, between their normals
};

/** Fits a plane to the matched pixels of surface 0 within 1 px of the truth.
 * \param[in] mask pixels that are used */
WallFit
fitWall(const MatchedDisparity& found,
        const SimulatedTruth& truth,
        const PixelMask& mask,
        const TrinocularRig& rig)
{
  std::vector<std::size_t> pixels;
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (mask[i] != 0 && truth.surfaces[i] == 0 &&
        std::abs(found.disparity.values[i] - truth.horizontal.values[i]) <=
            DisparityErrors::bad_error)
      pixels.push_back(i);
  // moments are about a point of the true wall
  const Eigen::Vector3d origin =
      pointOf(rig, pixels.front(), truth.horizontal.values[pixels.front()]);
  const auto planeOf = [&](const DisparityImage& disparities) {
    Moments moments;
    for (const std::size_t i : pixels)
      moments += momentsOf(pointOf(rig, i, disparities.values[i]) - origin);
    PlaneFit plane = fitPlane(moments);
    plane.mean += origin;
    if (plane.normal.z() < 0) // pointing away from the camera
      plane.normal = -plane.normal;
    return plane;
  };
  const PlaneFit plane = planeOf(found.disparity), exact = planeOf(truth.horizontal);
  std::vector<double> offs, steps;
  for (const std::size_t i : pixels) {
    const Eigen::Vector3d point = pointOf(rig, i, found.disparity.values[i]);
    offs.push_back(std::pow(plane.normal.dot(point - plane.mean), 2));
    // A disparity error moves its point along the ray.
    steps.push_back(std::pow(
        plane.normal.dot(point) * found.sigma[i] / found.disparity.values[i], 2));
  }
  return {std::sqrt(meanOf(offs)),
          std::sqrt(meanOf(steps)),
          exact.normal.dot(plane.mean - exact.mean),
          std::asin(plane.normal.cross(exact.normal).norm())};
}

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
  return [method](const StereoShots& shots) { return fusedDisparity(shots, method); };
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
  printHead("lit pixels that a neighbour sees | pixels | bad > 1 px or missing, % | of "
            "it wrong, % | median error, px | RMS of errors to 1 px | locking of "
            "means, px | of medians, px");
  for (const NamedFigures& one : all) {
    const DisparityErrors& errors = one.figures.matchable;
    Row() << one.name << errors.judged() << atMost(errors.bad(), one.reach.bad, 3)
          << figure(errors.wrong(), 3)
          << atMost(errors.medianError(), one.reach.error, 4) << figure(errors.rms(), 4)
          << atMost(one.figures.fractions.lockingOfMeans(), one.reach.locking, 4)
          << atMost(one.figures.fractions.lockingOfMedians(), one.reach.locking, 4);
  }
}

void
printAstray(const std::vector<NamedFigures>& all)
{
  printHead("pixels that cannot be matched | unlit | wrong there, % | a disparity "
            "there, % | lit but hidden | wrong there, % | a disparity there, %");
  for (const NamedFigures& one : all)
    Row() << one.name << one.figures.unlit.judged()
          << atMost(one.figures.unlit.wrong(), one.reach.astray, 2)
          << figure(one.figures.unlit.present(), 2) << one.figures.unseen.judged()
          << atMost(one.figures.unseen.wrong(), one.reach.astray, 2)
          << figure(one.figures.unseen.present(), 2);
}

void
printSigmas(const std::vector<NamedFigures>& all)
{
  constexpr double honest = 0.3; // maximum deviation from 1
  printHead("standard deviations | RMS of error / sigma, less 1 | mean sigma, px | RMS "
            "of errors, px | wall: RMS off the fitted plane, mm | the same by sigma, "
            "mm | fitted plane off the true one, mm | turned, mrad");
  for (const NamedFigures& one : all) {
    if (one.figures.walls.empty())
      continue;
    const auto wall = [&](double WallFit::*figure_of) {
      return milli * meanOf(valuesOf(one.figures.walls,
                                     [&](auto& fit) { return fit.*figure_of; }));
    };
    Row() << one.name << within(one.figures.sigmas.ratio() - 1, honest, 3)
          << figure(one.figures.sigmas.meanSigma(), 4)
          << figure(one.figures.matchable.rms(), 4) << figure(wall(&WallFit::rms), 2)
          << figure(wall(&WallFit::expected), 2) << figure(wall(&WallFit::offset), 2)
          << figure(wall(&WallFit::turn), 2);
  }
}

const Section simulated_section("simulated", [] {
  const SimulatedScene scene = wallWithBox();
  std::vector<SimulatedShots> views;
  for (std::size_t view = 0; view < scene.views.size(); ++view)
    views.push_back(takeShots(scene, view));
  const std::vector<NamedFigures> all = measureMethods(views);
  printErrors(all);
  printAstray(all);
  printSigmas(all);
});

/** The minimum CPU seconds of several runs. */
double
leastSeconds(const std::function<void()>& function)
{
  std::vector<double> seconds;
  for (int round = 0; round < 5; ++round)
    seconds.push_back(measureCost(function).cpu);
  return quantile(seconds, 0);
}

double
fusionSeconds(const StereoShots& shots, DisparityFusion::Method method)
{
  DisparityFusion fusion; // reused, as in a program, so that its memory is too
  fusion.setMethod(method);
  fusion.setInputRig(shots.rig);
  MatchedDisparity fused;
  return leastSeconds([&] {
    fusion.clear();
    for (const TrinocularFrame::ConstPtr& frame : shots.frames)
      fusion.addShot(frame);
    fusion.fuse(fused);
  });
}

double
singleSeconds(const StereoShots& shots)
{
  TrinocularMatching matching;
  matching.setInputRig(shots.rig);
  MatchedDisparity matched;
  return leastSeconds([&] { matching.match(*shots.frames.front(), matched); });
}

const Section time_section("time", [] {
  using Fusion = DisparityFusion::Method;
  constexpr double max_frames = 3; // of SGBM, for an observation by space-time
  const StereoShots three = takeShots(wallWithBox(), 0).shots;
  const StereoShots two = withoutVertical(three);
  cv::setNumThreads(1);
  SgbmSetting unpadded;
  unpadded.padded = false;
  const double sgbm =
      leastSeconds([&] { sgbmDisparity(*three.frames.front(), three.rig, unpadded); });
  printHead("640 × 480 pixels, 64 disparities | CPU, s | frames of OpenCV SGBM");
  const auto print = [&](const char* name, double seconds, double reach = no_reach) {
    Row() << name << figure(seconds, 3) << atMost(seconds / sgbm, reach, 2);
  };
  print("OpenCV SGBM, one pattern, two views", sgbm);
  print("acmap, one pattern, two views", singleSeconds(two));
  print("acmap, one pattern, three views", singleSeconds(three));
  print("acmap, space-time, 10 patterns, two views",
        fusionSeconds(two, Fusion::SpaceTime));
  print("acmap, space-time, 10 patterns, three views",
        fusionSeconds(three, Fusion::SpaceTime),
        max_frames);
  print("acmap, median, 10 patterns, three views",
        fusionSeconds(three, Fusion::Median));
  print("acmap, statistical, 10 patterns, three views",
        fusionSeconds(three, Fusion::Statistical));
});

} // namespace
} // namespace pcl::acmap::bench
