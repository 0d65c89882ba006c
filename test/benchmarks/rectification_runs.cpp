#include "rectification_runs.h"

#include "timing.h"

#include <pcl/core/random.h>

#include <cmath>

namespace pcl::acmap::bench {

DriftModel
robotDrift(double level)
{
  return {0.002 * level, 0.02 * level, 0.004 * level, 0.01 * level, 0.0015 * level};
}

DriftModel
cameraDrift()
{
  DriftModel drift;
  drift.length_per_metre = 0.01;
  drift.turn = 0.2 * M_PI / 180;
  return drift;
}

std::vector<PlanarPose>
drifted(const std::vector<PlanarPose>& truth,
        const DriftModel& drift,
        std::uint64_t seed)
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
  run.before = absoluteTrajectoryError(given, map.truth);
  run.after = absoluteTrajectoryError(run.found, map.truth);
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
