#include "stereo_matches.h"

#include <cmath>

namespace pcl::acmap::test {

namespace {

/** Adds noise along the ray that corresponds to a disparity error. */
Eigen::Vector3f
seen(const Eigen::Vector3d& place, double noise, Random& random)
{
  const double depth = place.z();
  const double along = noise * depth * depth * 0.1 / 52 * random.normal();
  const double across = noise * 0.5 * depth / 520;
  const double u = across * random.normal(), v = across * random.normal();
  return (place * (1 + along / depth) + Eigen::Vector3d(u, v, 0)).cast<float>();
}

Eigen::Vector3d
inBall(Random& random)
{
  for (;;) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    const Eigen::Vector3d place(x, y, random.uniform(-1, 1));
    if (place.norm() <= 1)
      return place;
  }
}

} // namespace

Eigen::Isometry3d
planarMotion(double dx, double dz, double theta)
{
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.rotate(Eigen::AngleAxisd(theta, Eigen::Vector3d::UnitY()));
  motion.translation() << dx, 0, dz;
  return motion;
}

Eigen::Isometry3d
anyMotion(Random& random)
{
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d axis = inBall(random).normalized();
  motion.rotate(Eigen::AngleAxisd(random.uniform(0, M_PI / 2), axis));
  motion.translation() = inBall(random);
  return motion;
}

StereoMatches
stereoMatches(const StereoMatchSettings& settings)
{
  StereoMatches matches;
  Random random(settings.seed);
  std::size_t right = settings.right, wrong = settings.wrong;
  while (right + wrong > 0) {
    const double depth = random.uniform(1, 6);
    const double x = random.uniform(-0.6, 0.6), y = random.uniform(-0.45, 0.45);
    const Eigen::Vector3d source = depth * Eigen::Vector3d(x, y, 1);
    Eigen::Vector3d target = settings.T_target_source * source;
    const bool is_right = random.uniform() * static_cast<double>(right + wrong) <
                          static_cast<double>(right);
    --(is_right ? right : wrong);
    if (!is_right)
      target += inBall(random);
    matches.source.push_back(seen(source, settings.noise, random));
    matches.target.push_back(seen(target, settings.noise, random));
    matches.is_right.push_back(is_right);
  }
  return matches;
}

std::vector<Eigen::Vector3d>
placesAt(const std::vector<Eigen::Vector3f>& places,
         const std::vector<std::int32_t>& positions)
{
  std::vector<Eigen::Vector3d> chosen;
  for (const std::int32_t position : positions)
    chosen.push_back(places[static_cast<std::size_t>(position)].cast<double>());
  return chosen;
}

std::vector<std::int32_t>
rightOnes(const StereoMatches& matches)
{
  std::vector<std::int32_t> positions;
  for (std::size_t i = 0; i < matches.is_right.size(); ++i)
    if (matches.is_right[i])
      positions.push_back(static_cast<std::int32_t>(i));
  return positions;
}

} // namespace pcl::acmap::test
