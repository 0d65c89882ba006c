#include "egomotion_runs.h"

#include "timing.h"

#include <pcl/core/planar_pose.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::bench {
namespace {

/** Motions and their errors. */
class RunTally {
public:
  RunTally(const EgomotionMethod& method, const EgomotionSequence& sequence)
  : method_(method)
  , sequence_(sequence)
  {
    run_.name = method.name;
  }

  /** Adds a motion and returns it; identity for a failure. */
  Eigen::Isometry3d
  add(std::size_t target, std::size_t source)
  {
    std::optional<Eigen::Isometry3d> found;
    run_.seconds +=
        measureCost([&] { found = method_.motion(sequence_, source, target); }).cpu;
    const Eigen::Isometry3d truth =
        sequence_.truth[target].inverse() * sequence_.truth[source];
    Eigen::Isometry3d motion = found.value_or(Eigen::Isometry3d::Identity());
    if (sequence_.is_planar)
      motion = isometryOf(planarPartOf(motion));
    const MotionError error = motionError(motion, truth);
    all_.push_back(error);
    if (found)
      estimated_.push_back(error);
    else
      ++run_.failures;
    run_.wrong += found && isWrong(error) ? 1 : 0;
    return motion;
  }

  EgomotionRun
  sum()
  {
    run_.estimated = summaryOf(estimated_);
    run_.all = summaryOf(all_);
    run_.seconds /= static_cast<double>(all_.size());
    return run_;
  }

private:
  const EgomotionMethod& method_;
  const EgomotionSequence& sequence_;
  EgomotionRun run_;
  std::vector<MotionError> estimated_, all_;
};

AbsoluteTrajectoryError
chainError(const EgomotionSequence& sequence,
           const std::vector<Eigen::Isometry3d>& found)
{
  if (!sequence.is_planar)
    return absoluteTrajectoryError(found, sequence.truth);
  const auto onFloor = [](const std::vector<Eigen::Isometry3d>& poses) {
    std::vector<PlanarPose> floor;
    for (const Eigen::Isometry3d& pose : poses)
      floor.push_back(planarPartOf(pose));
    return floor;
  };
  return absoluteTrajectoryError(onFloor(found), onFloor(sequence.truth));
}

} // namespace

bool
isWrong(const MotionError& error)
{
  constexpr double metres = 0.1, radians = 5 * M_PI / 180;
  return error.translation > metres || error.rotation > radians;
}

EgomotionRun
runChain(const EgomotionMethod& method, const EgomotionSequence& sequence)
{
  RunTally tally(method, sequence);
  std::vector<Eigen::Isometry3d> poses{sequence.truth.front()};
  for (std::size_t i = 1; i < sequence.clouds.size(); ++i)
    poses.push_back(poses.back() * tally.add(i - 1, i));
  EgomotionRun run = tally.sum();
  run.chain = chainError(sequence, poses);
  run.poses = std::move(poses);
  return run;
}

EgomotionRun
runApart(const EgomotionMethod& method,
         const EgomotionSequence& sequence,
         std::size_t step)
{
  constexpr std::size_t max_pairs = 25;
  RunTally tally(method, sequence);
  const std::size_t pairs = sequence.clouds.size() - step;
  const std::size_t every = (pairs + max_pairs - 1) / max_pairs;
  for (std::size_t i = 0; i < pairs; i += every)
    tally.add(i, i + step);
  return tally.sum();
}

} // namespace pcl::acmap::bench
