#pragma once

#include <pcl/core/random.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace pcl::acmap::test {

/** \brief A planar motion on the floor. */
Eigen::Isometry3d
planarMotion(double dx, double dz, double theta);

/** \brief Any motion, of up to pi / 2 and a metre per axis. */
Eigen::Isometry3d
anyMotion(Random& random);

/** \brief Parameters of simulated matches. */
struct StereoMatchSettings {
  std::size_t right = 200; ///< number of correct matches, of points at 1 to 6 m in the
                           ///< camera's view
  std::size_t wrong = 0;   ///< number of matches whose target is up to a metre off
  double noise = 1; ///< 1: as for a rig of 520 px and 10 cm with .1 px disparity noise
  Eigen::Isometry3d T_target_source = planarMotion(0.15, 0.3, 0.1);
  std::uint64_t seed = 1;
};

/** \brief Matches of points in two views, and which are correct; wrong ones are mixed
 * in. */
struct StereoMatches {
  std::vector<Eigen::Vector3f> source, target;
  std::vector<char> is_right;
};

StereoMatches
stereoMatches(const StereoMatchSettings& settings);

/** \brief The positions of some of them in double precision. */
std::vector<Eigen::Vector3d>
placesAt(const std::vector<Eigen::Vector3f>& places,
         const std::vector<std::int32_t>& positions);

/** \brief The indices of the correct ones. */
std::vector<std::int32_t>
rightOnes(const StereoMatches& matches);

} // namespace pcl::acmap::test
