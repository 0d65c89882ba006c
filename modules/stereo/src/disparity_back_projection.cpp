#include <pcl/core/exceptions.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/stereo/disparity_back_projection.h>

#include "back_projection/pixel_projection.h"
#include "matching/shot_check.h"

#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/parallel.h>

#include <utility>

namespace pcl {

namespace {

constexpr double min_maximum_depth = 0.01;
constexpr double farthest_depth = 10000.0;

void
requireSize(const char* name, int width, int height, const TrinocularRig& rig)
{
  if (width != rig.width || height != rig.height)
    throw acmap::BadArgument(std::string(name) + " has " +
                             acmap::sizeText(width, height) + " pixels, the rig has " +
                             acmap::sizeText(rig) + " pixels");
}

void
requireMatched(const MatchedDisparity& matched, const TrinocularRig& rig)
{
  const DisparityImage& disparity = matched.disparity;
  requireSize("the disparity image", disparity.width, disparity.height, rig);
  const std::size_t pixels =
      static_cast<std::size_t>(rig.width) * static_cast<std::size_t>(rig.height);
  if (disparity.values.size() != pixels)
    throw acmap::BadArgument("the disparity image has not all its values");
  if (!matched.sigma.empty() && matched.sigma.size() != pixels)
    throw acmap::BadArgument("there are " + std::to_string(matched.sigma.size()) +
                             " standard deviations of " + std::to_string(pixels) +
                             " disparities");
}

void
requireColor(const CameraImage& color, const TrinocularRig& rig)
{
  if (color.empty())
    return;
  requireSize("the colour image", color.width, color.height, rig);
  if (!isWhole(color))
    throw acmap::BadArgument("the colour image has " + std::to_string(color.channels) +
                             " channels, legal are 1 and 3, or not all its values");
}

} // namespace

void
DisparityBackProjection::setInputRig(const TrinocularRig& rig)
{
  acmap::requireStereoRig(rig);
  rig_ = rig;
}

const TrinocularRig&
DisparityBackProjection::getInputRig() const
{
  if (!rig_)
    throw acmap::InitFailed("DisparityBackProjection has no rig");
  return *rig_;
}

void
DisparityBackProjection::setMinimumDepth(double depth)
{
  acmap::requireInRange("minimum depth", depth, 0.0, farthest_depth, "m");
  minimum_depth_ = depth;
}

void
DisparityBackProjection::setMaximumDepth(double depth)
{
  acmap::requireInRange("maximum depth", depth, min_maximum_depth, farthest_depth, "m");
  maximum_depth_ = depth;
}

void
DisparityBackProjection::project(const MatchedDisparity& matched,
                                 const CameraImage& color,
                                 PointCloud<PointXYZRGBSigma>& cloud)
{
  const TrinocularRig& rig = getInputRig();
  requireMatched(matched, rig);
  requireColor(color, rig);
  if (minimum_depth_ >= maximum_depth_)
    acmap::refuseArgument("minimum depth",
                          minimum_depth_,
                          "below the maximum depth, " + std::to_string(maximum_depth_) +
                              " m");
  DisparityBackProjectionReport report;
  acmap::StepTimer timer(report);
  PointCloud<PointXYZRGBSigma> result(static_cast<std::uint32_t>(rig.width),
                                      static_cast<std::uint32_t>(rig.height));
  const acmap::PixelProjection projection(
      rig, {minimum_depth_, maximum_depth_}, matched, color);
  acmap::PixelCounts counts;
  acmap::withThreads(threads_, [&] {
    counts = projection.projectAll(result.points.data(), result.size());
  });
  report.points = counts.points;
  report.invalid = counts.invalid;
  report.too_near = counts.too_near;
  report.too_far = counts.too_far;
  result.is_dense = report.points == result.size();
  if (report.points == 0)
    report.remarks.emplace_back(
        "no pixel has a disparity of a depth within the limits: "
        "the cloud has colours, no places");
  timer.finish("back-projection");
  cloud = std::move(result);
  report_ = std::move(report);
}

} // namespace pcl
