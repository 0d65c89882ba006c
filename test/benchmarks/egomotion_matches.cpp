#include "egomotion_matches.h"

#include <pcl/common/io.h>
#include <pcl/egomotion/correspondence_estimation_log_polar.h>
#include <pcl/egomotion/gradient_maximum_keypoint.h>

#include <algorithm>

namespace pcl::acmap::bench {
namespace {

using Point = PointXYZRGB;
using Cloud = PointCloud<Point>;

IndicesPtr
keypointsOf(const Cloud::ConstPtr& cloud)
{
  GradientMaximumKeypoint<Point> detector;
  detector.setInputCloud(cloud);
  Cloud keypoints;
  detector.compute(keypoints);
  return std::make_shared<Indices>(detector.getKeypointsIndices()->indices);
}

Cloud::Ptr
withoutSigma(const EgomotionCloud& seen)
{
  const auto cloud = std::make_shared<Cloud>();
  copyPointCloud(seen, *cloud);
  return cloud;
}

} // namespace

MatchedPair
matchedPair(const EgomotionSequence& sequence, std::size_t target)
{
  const Cloud::ConstPtr before = withoutSigma(*sequence.clouds[target]);
  MatchedPair pair{withoutSigma(*sequence.clouds[target + 1]),
                   before,
                   keypointsOf(before),
                   {},
                   sequence.truth[target].inverse() * sequence.truth[target + 1]};
  registration::CorrespondenceEstimationLogPolar<Point> matcher;
  matcher.setMinimumContrast(1.5F); // grey levels: the grain of the walls is weak
  matcher.setInputSource(pair.source);
  matcher.setIndicesSource(keypointsOf(pair.source));
  matcher.setInputTarget(pair.target);
  matcher.setIndicesTarget(pair.target_keypoints);
  matcher.determineCorrespondences(pair.matches, 1.5); // metres
  return pair;
}

SpoiltMatches
spoilt(const MatchedPair& pair, double share, Random& random)
{
  const auto drawn = [&random](std::size_t count) {
    return std::min(
        count - 1,
        static_cast<std::size_t>(random.uniform() * static_cast<double>(count)));
  };
  SpoiltMatches matches{pair.matches, pair.matches};
  const auto wrong =
      static_cast<std::size_t>(share * static_cast<double>(pair.matches.size()));
  for (std::size_t i = 0; i < wrong;
       ++i) // partial shuffle; the first ones become wrong
    std::swap(matches.right[i], matches.right[i + drawn(matches.right.size() - i)]);
  matches.all = matches.right;
  matches.right.erase(matches.right.begin(),
                      matches.right.begin() + static_cast<std::ptrdiff_t>(wrong));
  for (std::size_t i = 0; i < wrong; ++i)
    matches.all[i].index_match =
        (*pair.target_keypoints)[drawn(pair.target_keypoints->size())];
  return matches;
}

} // namespace pcl::acmap::bench
