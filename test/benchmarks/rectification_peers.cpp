#include "rectification_peers.h"

#include "timing.h"

#include <pcl/common/io.h>
#include <pcl/common/transforms.h>
#include <pcl/registration/correspondence_estimation.h>
#include <pcl/registration/elch.h>
#include <pcl/registration/icp.h>
#include <pcl/registration/lum.h>

#include <cmath>

namespace pcl::acmap::bench {
namespace {

constexpr double largest_distance = 0.3; ///< maximum distance of corresponding points,
                                         ///< metres

using Points = PointCloud<PointXYZ>;

/** The clouds transformed by the given poses, in the frame of the first one. Both
 * methods then only compute small corrections, so that LUM's Euler angles stay
 * small. */
std::vector<Points::Ptr>
placedClouds(const RectificationMap& map, const std::vector<PlanarPose>& given)
{
  const Eigen::Isometry3d T_first_map = isometryOf(given.front()).inverse();
  std::vector<Points::Ptr> clouds;
  for (std::size_t i = 0; i < given.size(); ++i) {
    Points local;
    copyPointCloud(*map.clouds[i], local);
    const Eigen::Isometry3d pose = T_first_map * isometryOf(given[i]);
    clouds.push_back(std::make_shared<Points>());
    transformPointCloud(local, *clouds.back(), pose.cast<float>().matrix());
  }
  return clouds;
}

/** \param[in] correction in the frame of the first pose */
PlanarPose
corrected(const PlanarPose& given,
          const Eigen::Affine3f& correction,
          const PlanarPose& first)
{
  const Eigen::Isometry3d motion(correction.matrix().cast<double>());
  return planarPartOf(isometryOf(first) * motion * isometryOf(first).inverse() *
                      isometryOf(given));
}

CorrespondencesPtr
correspondencesOf(const Points::Ptr& source, const Points::Ptr& target)
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
  std::vector<Points::Ptr> placed;
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
runLum(const RectificationMap& map,
       const std::vector<PlanarPose>& given,
       const ObservationPairs& pairs)
{
  constexpr int rounds = 5;
  const std::vector<Points::Ptr> clouds = placedClouds(map, given);
  registration::LUM<PointXYZ> lum;
  lum.setMaxIterations(1);
  for (const Points::Ptr& cloud : clouds)
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
runElch(const RectificationMap& map, const std::vector<PlanarPose>& given)
{
  constexpr int iterations = 100;
  registration::ELCH<PointXYZ> elch;
  const auto icp = std::make_shared<IterativeClosestPoint<PointXYZ, PointXYZ>>();
  icp->setMaximumIterations(iterations);
  icp->setMaxCorrespondenceDistance(largest_distance);
  elch.setReg(icp);
  for (const Points::Ptr& cloud : placedClouds(map, given))
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
