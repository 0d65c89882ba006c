#include "rectification_peers.h"

#include "bench.h"

#include <pcl/common/io.h>
#include <pcl/common/transforms.h>
#include <pcl/registration/correspondence_estimation.h>
#include <pcl/registration/elch.h>
#include <pcl/registration/icp.h>
#include <pcl/registration/lum.h>

namespace pcl::acmap::bench {
namespace {

constexpr double largest_distance = 0.3; ///< maximum distance of corresponding points,
                                         ///< metres

using PeerPoints = PointCloud<PointXYZ>;

/** The clouds transformed by the given poses, in the frame of the first one. Both
 * methods then only compute small corrections, so that LUM's Euler angles stay
 * small. */
std::vector<PeerPoints::Ptr>
placedClouds(const PeerClouds& clouds, const std::vector<Eigen::Isometry3d>& given)
{
  const Eigen::Isometry3d T_first_map = given.front().inverse();
  std::vector<PeerPoints::Ptr> placed;
  for (std::size_t i = 0; i < given.size(); ++i) {
    PeerPoints local;
    copyPointCloud(*clouds[i], local);
    const Eigen::Isometry3d pose = T_first_map * given[i];
    placed.push_back(std::make_shared<PeerPoints>());
    transformPointCloud(local, *placed.back(), pose.cast<float>().matrix());
  }
  return placed;
}

/** \param[in] correction in the frame of the first pose */
Eigen::Isometry3d
corrected(const Eigen::Isometry3d& given,
          const Eigen::Affine3f& correction,
          const Eigen::Isometry3d& first)
{
  return first * motionOf(correction.matrix()) * first.inverse() * given;
}

CorrespondencesPtr
correspondencesOf(const PeerPoints::Ptr& source, const PeerPoints::Ptr& target)
{
  registration::CorrespondenceEstimation<PointXYZ, PointXYZ> estimation;
  estimation.setInputSource(source);
  estimation.setInputTarget(target);
  const auto found = std::make_shared<Correspondences>();
  estimation.determineCorrespondences(*found, largest_distance);
  return found;
}

void
setCorrespondences(registration::LUM<PointXYZ>& lum, const ObservationPairs& pairs)
{
  std::vector<PeerPoints::Ptr> placed;
  for (std::size_t i = 0; i < lum.getNumVertices(); ++i)
    placed.push_back(lum.getTransformedCloud(i));
  for (const auto& [a, b] : pairs) {
    const CorrespondencesPtr found = correspondencesOf(placed[a], placed[b]);
    if (found->size() > 2)
      lum.setCorrespondences(a, b, found);
  }
}

} // namespace

ObservationPairs
truePairs(const RectificationMap& map)
{
  constexpr std::size_t another_time = 10;
  constexpr double near = 1, alike = M_PI / 6; // metres, radians
  ObservationPairs pairs;
  for (std::size_t b = 1; b < map.truth.size(); ++b) {
    pairs.emplace_back(b - 1, b);
    for (std::size_t a = 0; a + another_time < b; ++a) {
      const PlanarAction way = actionBetween(map.truth[a], map.truth[b]);
      if (std::hypot(way.dx, way.dz) < near && std::abs(way.dtheta) < alike)
        pairs.emplace_back(a, b);
    }
  }
  return pairs;
}

PeerRun
runLum(const PeerClouds& clouds,
       const std::vector<Eigen::Isometry3d>& given,
       const ObservationPairs& pairs)
{
  constexpr int rounds = 5;
  registration::LUM<PointXYZ> lum;
  lum.setMaxIterations(1);
  for (const PeerPoints::Ptr& cloud : placedClouds(clouds, given))
    lum.addPointCloud(cloud);
  PeerRun run;
  run.seconds = measureThread([&] {
    for (int round = 0; round < rounds; ++round) {
      setCorrespondences(lum, pairs);
      lum.compute();
    }
  });
  for (std::size_t i = 0; i < given.size(); ++i)
    run.poses.push_back(corrected(given[i], lum.getTransformation(i), given.front()));
  return run;
}

PeerRun
runElch(const PeerClouds& clouds, const std::vector<Eigen::Isometry3d>& given)
{
  constexpr int iterations = 100;
  registration::ELCH<PointXYZ> elch;
  const auto icp = std::make_shared<IterativeClosestPoint<PointXYZ, PointXYZ>>();
  icp->setMaximumIterations(iterations);
  icp->setMaxCorrespondenceDistance(largest_distance);
  elch.setReg(icp);
  for (const PeerPoints::Ptr& cloud : placedClouds(clouds, given))
    elch.addPointCloud(cloud);
  elch.setLoopStart(0);
  elch.setLoopEnd(given.size() - 1);
  PeerRun run;
  run.seconds = measureThread([&] { elch.compute(); });
  for (std::size_t i = 0; i < given.size(); ++i)
    run.poses.push_back(
        corrected(given[i], (*elch.getLoopGraph())[i].transform, given.front()));
  return run;
}

} // namespace pcl::acmap::bench
