#pragma once

#include "rectification_runs.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief What is unusual about a run. */
enum class GuardVariant {
  Plain,
  ThinnedScans,   ///< every second scan, and every second beam of it
  ShortRays,      ///< 5 m at most
  MovedFurniture, ///< some boxes are there during one half of the recording only
  ToldTooSmall,   ///< the odometry's noise is stated as a third of the usual one
  ToldTooLarge,   ///< as three times the usual one
  HeavyTails,     ///< one action in ten has four times the noise
  Bias            ///< turns are biased by four times as much, and lengths by 3 %
};

/** \brief A map with wrong poses, of which the guard has to judge the rectification. */
struct GuardCase {
  std::string kind; ///< of the building, or the name of a log
  std::uint64_t seed = 1;
  double level = 1; ///< factor of the usual drift
  GuardVariant variant = GuardVariant::Plain;
  RectificationMap map;
  std::vector<PlanarPose> given;
  OdometryNoise told;
};

std::string
nameOf(GuardVariant variant);

/** \brief Drift and variant follow from the seed: forty successive seeds have each
 * combination of five levels, 0.5 to 8, and eight variants. */
double
driftLevelOf(std::uint64_t seed);

GuardVariant
variantOf(std::uint64_t seed);

/** \brief Makes the map and the odometry of a run. \param[in] kind of a building, or the name
 * of a log */
GuardCase
makeGuardCase(const std::string& kind, std::uint64_t seed);

} // namespace pcl::acmap::bench
