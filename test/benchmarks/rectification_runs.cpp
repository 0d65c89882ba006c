#include "rectification_runs.h"

#include "timing.h"

#include <pcl/core/random.h>

#include <cmath>

namespace pcl::acmap::bench {
namespace {

Eigen::Matrix2Xd
placesOf(const std::vector<PlanarPose>& poses)
{
  Eigen::Matrix2Xd places(2, static_cast<Eigen::Index>(poses.size()));
  for (std::size_t i = 0; i < poses.size(); ++i)
    places.col(static_cast<Eigen::Index>(i)) << poses[i].x, poses[i].z;
  return places;
}

double
rootMeanSquare(const Eigen::Matrix2Xd& differences)
{
  return std::sqrt(differences.colwise().squaredNorm().mean());
}

/** After the turn and the shift that take \a found nearest to \a wanted (Umeyama). */
double
alignedError(const Eigen::Matrix2Xd& found, const Eigen::Matrix2Xd& wanted)
{
  const Eigen::Matrix2Xd from = found.colwise() - found.rowwise().mean();
  const Eigen::Matrix2Xd to = wanted.colwise() - wanted.rowwise().mean();
  const Eigen::Matrix2d products = to * from.transpose();
  const Eigen::Rotation2Dd turn(
      std::atan2(products(1, 0) - products(0, 1), products.trace()));
  return rootMeanSquare(turn.toRotationMatrix() * from - to);
}

} // namespace

Drift
robotDrift(double level)
{
  return {0.002 * level, 0.02 * level, 0.004 * level, 0.01 * level, 0.0015 * level};
}

Drift
cameraDrift()
{
  Drift drift;
  drift.length_per_metre = 0.01;
  drift.turn = 0.2 * M_PI / 180;
  return drift;
}

std::vector<PlanarPose>
drifted(const std::vector<PlanarPose>& truth, const Drift& drift, std::uint64_t seed)
{
  Random random(seed);
  std::vector<PlanarPose> poses{truth.front()};
  for (std::size_t i = 1; i < truth.size(); ++i) {
    PlanarAction action = actionBetween(truth[i - 1], truth[i]);
    const double way = std::hypot(action.dx, action.dz);
    const double length = drift.length + drift.length_per_metre * way;
    const double turn = drift.turn + drift.turn_per_radian * std::abs(action.dtheta);
    action.dx += length * random.normal();
    action.dz += length * random.normal();
    action.dtheta += turn * random.normal() + drift.turn_bias;
    poses.push_back(moved(poses.back(), action));
  }
  return poses;
}

PathError
errorOf(const std::vector<PlanarPose>& poses, const std::vector<PlanarPose>& truth)
{
  const Eigen::Matrix2Xd found = placesOf(poses);
  const Eigen::Matrix2Xd wanted = placesOf(truth);
  return {rootMeanSquare(found - wanted), alignedError(found, wanted)};
}

RectificationRun
rectifyMap(const RectificationMap& map,
           const std::vector<PlanarPose>& given,
           const std::function<void(Rectification&)>& configure)
{
  Rectification rectification;
  rectification.setNumberOfThreads(1);
  rectification.setBinSize(map.bin_size);
  if (configure)
    configure(rectification);
  for (std::size_t i = 0; i < map.clouds.size(); ++i)
    rectification.addPointCloud(map.clouds[i], isometryOf(given[i]), map.weights[i]);
  RectificationRun run;
  run.name = map.name;
  run.given = given;
  run.seconds = measureCost([&] { rectification.compute(); }).cpu;
  for (std::size_t i = 0; i < given.size(); ++i)
    run.found.push_back(planarPartOf(rectification.getPose(i)));
  run.report = rectification.getReport();
  run.before = errorOf(given, map.truth);
  run.after = errorOf(run.found, map.truth);
  return run;
}

std::string
nameOf(RectificationOutcome outcome)
{
  switch (outcome) {
  case RectificationOutcome::Rectified:
    return "rectified";
  case RectificationOutcome::Kept:
    return "kept";
  case RectificationOutcome::Refused:
    return "refused";
  case RectificationOutcome::Undetermined:
    break;
  }
  return "undetermined";
}

} // namespace pcl::acmap::bench
