#pragma once

#include <pcl/core/random.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace pcl::acmap::test {

/** \brief A motion on the floor. */
Eigen::Isometry3d
planarMotion(double dx, double dz, double theta);

/** \brief Any motion, of up to pi / 2 and a metre an axis. */
Eigen::Isometry3d
anyMotion(Random& random);

/** \brief How matches are made. */
struct StereoMatchSettings {
  std::size_t right = 200; ///< of points 1 to 6 m off, in a camera's view
  std::size_t wrong = 0;   ///< whose target is up to a metre off
  double noise = 1; ///< 1: as of a rig of 520 px and 10 cm with .1 px of disparity
  Eigen::Isometry3d T_target_source = planarMotion(0.15, 0.3, 0.1);
  std::uint64_t seed = 1;
};

/** \brief Matches of points in two views, and which are right; the wrong lie among the
 * right. */
struct StereoMatches {
  std::vector<Eigen::Vector3f> source, target;
  std::vector<char> is_right;
};

StereoMatches
stereoMatches(const StereoMatchSettings& settings);

/** \brief The places of some of them, in double. */
std::vector<Eigen::Vector3d>
placesAt(const std::vector<Eigen::Vector3f>& places,
         const std::vector<std::int32_t>& positions);

/** \brief The positions of the right ones. */
std::vector<std::int32_t>
rightOnes(const StereoMatches& matches);

} // namespace pcl::acmap::test
