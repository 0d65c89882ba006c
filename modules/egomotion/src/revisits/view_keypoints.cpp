#include "revisits/view_keypoints.h"

#include <opencv2/features2d.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::acmap {

namespace {

constexpr int max_keypoints = 1000;
constexpr int patch_size = 31; // of ORB at its finest level, pixels
constexpr int min_corner = 5;  // grey levels, of FAST

cv::Mat
bytesOf(const GreyImage& image)
{
  cv::Mat bytes(image.height, image.width, CV_8U);
  std::transform(image.values.begin(), image.values.end(), bytes.data, [](float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 255.0F)));
  });
  return bytes;
}

bool
hasPlace(const CameraView& view, std::size_t pixel)
{
  return view.points[pixel].allFinite() && view.points[pixel].z() > 0;
}

cv::Mat
maskOf(const CameraView& view)
{
  cv::Mat mask(view.image.height, view.image.width, CV_8U);
  for (std::size_t i = 0; i < view.points.size(); ++i)
    mask.data[i] = hasPlace(view, i) ? 255 : 0;
  return mask;
}

/** The index of the nearest row of \a other for each row, if it is clearly nearer than
 * the second one, otherwise -1. */
std::vector<int>
clearlyNearest(const cv::Mat& rows, const cv::Mat& other)
{
  constexpr float max_ratio = 0.8F;
  std::vector<std::vector<cv::DMatch>> nearest;
  cv::BFMatcher(cv::NORM_HAMMING).knnMatch(rows, other, nearest, 2);
  std::vector<int> found(static_cast<std::size_t>(rows.rows), -1);
  for (const std::vector<cv::DMatch>& pair : nearest)
    if (pair.size() == 2 && pair[0].distance < max_ratio * pair[1].distance)
      found[static_cast<std::size_t>(pair[0].queryIdx)] = pair[0].trainIdx;
  return found;
}

} // namespace

ViewKeypoints
keypointsOf(const CameraView& view)
{
  ViewKeypoints result;
  if (view.points.empty())
    return result;
  const auto pinhole =
      fitUprightPinhole({view.points.data(), sizeof view.points[0], view.points.size()},
                        static_cast<std::size_t>(view.image.width));
  std::vector<cv::KeyPoint> corners;
  cv::Mat descriptors;
  const cv::Ptr<cv::ORB> orb = cv::ORB::create(max_keypoints);
  orb->setFastThreshold(min_corner);
  orb->setEdgeThreshold(patch_size / 2 + 1);
  orb->detectAndCompute(bytesOf(view.image), maskOf(view), corners, descriptors);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const int column = std::clamp(
        static_cast<int>(std::lround(corners[i].pt.x)), 0, view.image.width - 1);
    const int row = std::clamp(
        static_cast<int>(std::lround(corners[i].pt.y)), 0, view.image.height - 1);
    const int pixel = row * view.image.width + column;
    if (!hasPlace(view, static_cast<std::size_t>(pixel)))
      continue;
    const Eigen::Vector3d place =
        view.points[static_cast<std::size_t>(pixel)].cast<double>();
    result.keypoints.push_back(
        {pixel,
         place,
         placeCovariance(place,
                         view.sigmas[static_cast<std::size_t>(pixel)],
                         corners[i].size / patch_size,
                         pinhole)});
    result.descriptors.push_back(descriptors.row(static_cast<int>(i)));
  }
  return result;
}

std::vector<FeaturePair>
alikePairs(const ViewKeypoints& source, const ViewKeypoints& target)
{
  std::vector<FeaturePair> pairs;
  if (source.keypoints.empty() || target.keypoints.empty())
    return pairs;
  const std::vector<int> there = clearlyNearest(source.descriptors, target.descriptors);
  const std::vector<int> back = clearlyNearest(target.descriptors, source.descriptors);
  for (std::size_t i = 0; i < there.size(); ++i) {
    if (there[i] < 0 || back[static_cast<std::size_t>(there[i])] != static_cast<int>(i))
      continue;
    const PlaceKeypoint& now = source.keypoints[i];
    const PlaceKeypoint& before = target.keypoints[static_cast<std::size_t>(there[i])];
    pairs.push_back({now.pixel,
                     before.pixel,
                     now.place,
                     before.place,
                     now.covariance,
                     before.covariance});
  }
  return pairs;
}

} // namespace pcl::acmap
