#include "motion_fit/motion_energy.h"

#include <pcl/core/impl/rotation_vector.h>

#include <algorithm>

namespace pcl::acmap {

namespace {

constexpr std::size_t max_iterations = 100;
constexpr double min_step = 1e-13; ///< relative to the extent of the points, radians
constexpr double converged_step = 1e-7;

void
turn(Descent& at, const Eigen::Vector3d& turn)
{
  at.rotation = Eigen::Quaterniond(rotationOf(turn)) * at.rotation;
  at.rotation.normalize();
}

/** The initial offset between the centroids, without rotation. */
Descent
startOf(const PairMoments& moments, MotionModel model)
{
  Descent start;
  start.offset = (moments.source - moments.target) / moments.scale;
  if (model == MotionModel::Planar)
    start.offset.y() = 0;
  return start;
}

} // namespace

Descent
descend(const PairMoments& moments, MotionModel model)
{
  const MotionEnergy energy(moments, model);
  const std::size_t restart_after = model == MotionModel::Planar ? 3 : 6;
  Descent at = startOf(moments, model);
  MotionStep direction = MotionStep::Zero();
  MotionStep last_step = MotionStep::Zero();
  double last_square = 0;
  for (std::size_t since_restart = 0; at.iterations < max_iterations; ++at.iterations) {
    const MotionStep gradient = energy.gradient(at);
    const MotionStep step = energy.preconditioned(at, gradient);
    at.has_converged = step.norm() <= converged_step;
    if (step.norm() <= min_step) {
      const std::optional<Eigen::Vector3d> axis = energy.ridge(at);
      if (!axis)
        break;
      turn(at, *axis); // leaves the stationary point; any angle is suitable
      since_restart = 0;
      continue;
    }
    // Polak-Ribiere+; restarted if the direction is not one of descent.
    const double square = gradient.dot(step);
    const double share =
        since_restart == 0
            ? 0.0
            : std::max(0.0, (square - gradient.dot(last_step)) / last_square);
    direction = share * direction - step;
    if (gradient.dot(direction) >= 0)
      direction = -step;
    since_restart = (since_restart + 1) % restart_after;
    last_step = step;
    last_square = square;

    const double way = energy.lowest(at, direction);
    at.offset += way * direction.head<3>();
    turn(at, way * direction.tail<3>());
  }
  return at;
}

} // namespace pcl::acmap
