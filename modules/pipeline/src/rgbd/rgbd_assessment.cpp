#include "rgbd/depth_numbers.h"
#include "rgbd/edge_agreement.h"
#include "rgbd/image_sizes.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/pipeline/rgbd_assessment.h>
#include <pcl/pipeline/rgbd_observation.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl {

namespace {

using acmap::shortNumber;

void
assessScale(const acmap::DepthNumbers& numbers, double scale, RgbdAssessment& found)
{
  constexpr double nearest_room = 0.35, farthest_room = 10; // metres, medians
  constexpr double alike = 3.3; // stereo cameras have finer steps than a Kinect
  constexpr int tum_unit = 5;
  constexpr std::uint64_t min_depths = 1000;
  constexpr double farthest_depth = 100; // metres
  found.common_divisor = numbers.commonDivisor();
  found.scale_of_steps = numbers.scaleOfSteps();
  found.median_depth = numbers.median() / scale;
  if (found.median_depth > farthest_depth)
    found.remarks.push_back(
        "half of the points are farther than " + shortNumber(found.median_depth) +
        " m: are there " + shortNumber(scale) +
        " of the depth images' numbers in a metre? --depth-scale tells");
  if (found.median_depth > farthest_depth || numbers.count() < min_depths)
    return;
  const std::string assumed = "depth: took " + acmap::depthScaleText(scale) +
                              " for a metre, which makes the median depth " +
                              shortNumber(found.median_depth) + " m";
  const std::string option = "; --depth-scale states another number";
  const double steps = found.scale_of_steps.value_or(scale);
  if (steps > alike * scale || alike * steps < scale)
    found.remarks.push_back(
        assumed + ", but the steps of the depths are those of about " +
        acmap::depthScaleText(std::round(steps / 500) * 500) + option);
  else if (found.common_divisor == tum_unit && scale == 1000)
    found.remarks.push_back(assumed + ", but all numbers are multiples of " +
                            std::to_string(tum_unit) + ", as where 5000 are a metre" +
                            option);
  else if (found.median_depth < nearest_room || found.median_depth > farthest_room)
    found.remarks.push_back(assumed + ", which is " +
                            (found.median_depth < nearest_room ? "less" : "more") +
                            " than rooms have" + option);
}

void
assessShift(const acmap::EdgeAgreement& edges,
            std::int32_t width,
            RgbdAssessment& found)
{
  constexpr double tolerated = 0.016; // of the width
  found.color_shift = edges.bestShift();
  if (found.color_shift && found.color_shift->norm() > tolerated * width)
    found.remarks.push_back("colours and depths do not show the same: their edges "
                            "agree best where the colours "
                            "are shifted by " +
                            shortNumber(found.color_shift->x()) + ", " +
                            shortNumber(found.color_shift->y()) +
                            " pixels; --color-camera states the camera of the colours");
}

} // namespace

std::string
acmap::depthScaleText(double scale)
{
  constexpr int digits = 9;
  std::ostringstream text;
  text.precision(digits);
  text << scale << " numbers";
  return text.str();
}

RgbdAssessment
assessRgbd(const RgbdSequence& sequence, const RgbdCameras& cameras)
{
  constexpr std::size_t max_frames = 5;
  RgbdAssessment found;
  acmap::DepthNumbers numbers;
  acmap::EdgeAgreement edges;
  const std::size_t count = sequence.frames.size();
  const std::size_t frames = std::min(count, max_frames);
  RgbdCameras unrefined = cameras;
  unrefined.sensor = DepthSensor::Laser;
  std::int32_t width = 0;
  for (std::size_t i = 0; i < frames; ++i) {
    const RgbdFrame& frame = sequence.frames[i * count / frames];
    try {
      numbers.add(loadGrayImage16(frame.depth).values);
      if (!frame.color.empty()) {
        const RgbdObservation seen = loadRgbdObservation(frame, unrefined);
        if (!cameras.color && !acmap::areSame(seen.sizes.color, seen.sizes.depth) &&
            found.remarks.empty())
          found.remarks.push_back("colour images of " +
                                  acmap::sizeText(seen.sizes.color) +
                                  " pixels are scaled to the depth images' " +
                                  acmap::sizeText(seen.sizes.depth) +
                                  "; --color-camera states a camera of their own");
        width = static_cast<std::int32_t>(seen.cloud.width);
        edges.add(seen.cloud);
      }
      ++found.frames;
    }
    catch (const InputFileException&) {
      continue; // is named when it is read for the map
    }
  }
  if (numbers.count() == 0)
    return found;
  assessScale(numbers, cameras.meaning.scale, found);
  if (width > 0)
    assessShift(edges, width, found);
  return found;
}

} // namespace pcl
