#include "egomotion_methods.h"

#include <opencv2/calib3d.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <string>

namespace pcl::acmap::bench {
namespace {

struct OrbView {
  std::vector<cv::KeyPoint> keypoints;
  cv::Mat descriptors;
};

OrbView
describe(const EgomotionCloud& cloud, const OrbSetting& setting)
{
  cv::Mat color(static_cast<int>(cloud.height), static_cast<int>(cloud.width), CV_8UC3);
  auto* value = color.data;
  for (const PointXYZRGBSigma& point : cloud)
    for (const std::uint8_t channel : {point.r, point.g, point.b})
      *value++ = channel;
  cv::Mat grey;
  cv::cvtColor(color, grey, cv::COLOR_RGB2GRAY);
  OrbView view;
  const cv::Ptr<cv::ORB> orb = cv::ORB::create(setting.features);
  orb->setFastThreshold(setting.fast_threshold);
  orb->detectAndCompute(grey, cv::noArray(), view.keypoints, view.descriptors);
  return view;
}

/** Matches from source to target. */
std::vector<cv::DMatch>
matchesOf(const OrbView& source, const OrbView& target, double ratio)
{
  std::vector<cv::DMatch> matches;
  if (source.keypoints.empty() || target.keypoints.empty())
    return matches;
  if (ratio >= 1) {
    cv::BFMatcher(cv::NORM_HAMMING, true)
        .match(source.descriptors, target.descriptors, matches);
    return matches;
  }
  std::vector<std::vector<cv::DMatch>> nearest;
  cv::BFMatcher(cv::NORM_HAMMING)
      .knnMatch(source.descriptors, target.descriptors, nearest, 2);
  for (const std::vector<cv::DMatch>& pair : nearest)
    if (pair.size() == 2 && pair[0].distance < ratio * pair[1].distance)
      matches.push_back(pair[0]);
  return matches;
}

/** Points of the target with their pixels in the source. */
struct PnpInput {
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> pixels;
};

PnpInput
pointsOf(const EgomotionCloud& cloud,
         const std::vector<cv::DMatch>& matches,
         const OrbView& source,
         const OrbView& target)
{
  PnpInput input;
  for (const cv::DMatch& match : matches) {
    const cv::Point seen =
        target.keypoints[static_cast<std::size_t>(match.trainIdx)].pt;
    const PointXYZRGBSigma& point = cloud.at(seen.x, seen.y);
    if (std::isnan(point.z))
      continue;
    input.points.emplace_back(point.x, point.y, point.z);
    input.pixels.emplace_back(
        source.keypoints[static_cast<std::size_t>(match.queryIdx)].pt);
  }
  return input;
}

std::optional<Eigen::Isometry3d>
poseOf(const PnpInput& input, const TrinocularRig& rig, const OrbSetting& setting)
{
  constexpr int iterations = 1000;
  constexpr double confidence = 0.999;
  const cv::Matx33d camera(rig.focal_length,
                           0,
                           rig.center_x, //
                           0,
                           rig.focal_length,
                           rig.center_y, //
                           0,
                           0,
                           1);
  if (static_cast<int>(input.points.size()) < setting.min_inliers)
    return std::nullopt;
  cv::Vec3d turn, shift;
  std::vector<int> inliers;
  cv::theRNG().state = 1; // the same for each pair
  if (!cv::solvePnPRansac(input.points,
                          input.pixels,
                          camera,
                          cv::noArray(),
                          turn,
                          shift,
                          false,
                          iterations,
                          static_cast<float>(setting.tolerance),
                          confidence,
                          inliers,
                          cv::SOLVEPNP_EPNP) ||
      static_cast<int>(inliers.size()) < setting.min_inliers)
    return std::nullopt;
  PnpInput good;
  for (const int i : inliers) {
    good.points.push_back(input.points[static_cast<std::size_t>(i)]);
    good.pixels.push_back(input.pixels[static_cast<std::size_t>(i)]);
  }
  cv::solvePnPRefineLM(good.points, good.pixels, camera, cv::noArray(), turn, shift);
  const Eigen::Vector3d axis(turn[0], turn[1], turn[2]);
  Eigen::Isometry3d T_source_target(
      Eigen::AngleAxisd(axis.norm(), axis.stableNormalized()));
  T_source_target.translation() << shift[0], shift[1], shift[2];
  return T_source_target.inverse();
}

} // namespace

EgomotionMethod
orbMethod(const OrbSetting& setting)
{
  return {"OpenCV ORB (" + std::to_string(setting.features) + ", FAST " +
              std::to_string(setting.fast_threshold) + ") + PnP",
          [setting](const EgomotionSequence& sequence,
                    std::size_t source,
                    std::size_t target) {
            cv::setNumThreads(1);
            const OrbView now = describe(*sequence.clouds[source], setting);
            const OrbView before = describe(*sequence.clouds[target], setting);
            return poseOf(pointsOf(*sequence.clouds[target],
                                   matchesOf(now, before, setting.ratio),
                                   now,
                                   before),
                          sequence.camera,
                          setting);
          }};
}

} // namespace pcl::acmap::bench
