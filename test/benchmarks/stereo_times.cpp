#include "markdown_row.h"
#include "sgbm_disparity.h"
#include "simulated_shots.h"
#include "stereo_tables.h"
#include "timing.h"

#include <pcl/stereo/disparity_fusion.h>

#include <algorithm>
#include <functional>
#include <opencv2/core/utility.hpp>

namespace pcl::acmap::bench {
namespace {

constexpr double max_frames = 3.0; // of SGBM, for an observation by space-time

/** The minimum CPU seconds of several runs. */
double
leastSeconds(const std::function<void()>& function)
{
  constexpr std::size_t rounds = 5;
  double minimum = measureCost(function).cpu;
  for (std::size_t round = 1; round < rounds; ++round)
    minimum = std::min(minimum, measureCost(function).cpu);
  return minimum;
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

void
printSeconds(const std::string& name,
             double seconds,
             double of_sgbm,
             double reach = no_reach)
{
  MarkdownRow()
      .text(name)
      .number(seconds, 3)
      .atMost(seconds / of_sgbm, reach, 2)
      .print();
}

} // namespace

void
printStereoTimes()
{
  using Method = DisparityFusion::Method;
  const StereoShots three = takeShots(wallWithBox(), 0).shots;
  const StereoShots two = withoutVertical(three);
  cv::setNumThreads(1);
  SgbmSetting unpadded;
  unpadded.padded = false;
  const double sgbm =
      leastSeconds([&] { sgbmDisparity(*three.frames.front(), three.rig, unpadded); });
  printHead({"640 × 480 pixels, 64 disparities", "CPU, s", "frames of OpenCV SGBM"});
  printSeconds("OpenCV SGBM, one pattern, two views", sgbm, sgbm);
  printSeconds("acmap, one pattern, two views", singleSeconds(two), sgbm);
  printSeconds("acmap, one pattern, three views", singleSeconds(three), sgbm);
  printSeconds("acmap, space-time, 10 patterns, two views",
               fusionSeconds(two, Method::SpaceTime),
               sgbm);
  printSeconds("acmap, space-time, 10 patterns, three views",
               fusionSeconds(three, Method::SpaceTime),
               sgbm,
               max_frames);
  printSeconds("acmap, median, 10 patterns, three views",
               fusionSeconds(three, Method::Median),
               sgbm);
  printSeconds("acmap, statistical, 10 patterns, three views",
               fusionSeconds(three, Method::Statistical),
               sgbm);
}

} // namespace pcl::acmap::bench
