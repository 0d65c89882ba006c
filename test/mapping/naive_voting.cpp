#include "naive_voting.h"

#include <pcl/core/random.h>

#include <array>
#include <cmath>

namespace pcl::acmap::test {
namespace {

using Action = std::array<double, 3>; ///< dx, dz, dtheta

/** a_0 is the first pose; the others are in the frame of the pose before. */
std::vector<Action>
actionsOf(const std::vector<PlanarPose>& poses)
{
  std::vector<Action> actions;
  PlanarPose a;
  for (const PlanarPose& b : poses) {
    actions.push_back(
        {std::cos(a.theta) * (b.x - a.x) - std::sin(a.theta) * (b.z - a.z),
         std::sin(a.theta) * (b.x - a.x) + std::cos(a.theta) * (b.z - a.z),
         b.theta - a.theta});
    a = b;
  }
  return actions;
}

std::vector<PlanarPose>
pathOf(const std::vector<Action>& actions)
{
  std::vector<PlanarPose> poses;
  PlanarPose last;
  for (const Action& action : actions) {
    const double c = std::cos(last.theta), s = std::sin(last.theta);
    last = {last.x + c * action[0] + s * action[1],
            last.z - s * action[0] + c * action[1],
            last.theta + action[2]};
    poses.push_back(last);
  }
  return poses;
}

} // namespace

NaiveVoting
naiveVoting(const PosedClouds& map,
            const NaiveEntropySettings& settings,
            std::uint64_t seed)
{
  const Action unit{0.05, 0.05, 0.02};
  std::vector<Action> actions = actionsOf(map.poses);
  std::vector<Action> past(actions.size(), {0, 0, 0}); // energy times change
  Random random(seed);
  const auto energyOf = [&](const std::vector<Action>& of) {
    return naiveEntropy({map.clouds, pathOf(of)}, settings).total;
  };
  NaiveVoting result;
  result.energy = energyOf(actions);
  double step = 1;
  const std::size_t maximum = 50 * actions.size();
  while (result.votes < maximum) {
    ++result.votes;
    std::vector<bool> changes(actions.size(), false);
    for (std::size_t count = 0; count < 2;) {
      count = 0;
      for (std::size_t t = 0; t < actions.size(); ++t)
        count += changes[t] = random.uniform() < 0.5;
    }
    double squares = 0;
    for (const Action& one : past)
      for (const double part : one)
        squares += part * part;
    const double size = std::sqrt(squares / (3 * static_cast<double>(past.size())));
    std::vector<Action> change(actions.size(), {0, 0, 0}), tried = actions;
    for (std::size_t t = 0; t < actions.size(); ++t)
      for (std::size_t k = 0; k < 3 && changes[t]; ++k) {
        change[t][k] = 0.5 * random.normal() - (size > 0 ? past[t][k] / size : 0);
        tried[t][k] += step * unit[k] * change[t][k];
      }
    const double energy = energyOf(tried);
    for (std::size_t t = 0; t < actions.size(); ++t)
      for (std::size_t k = 0; k < 3 && changes[t]; ++k)
        past[t][k] =
            0.9 * past[t][k] + 0.1 * (energy - result.energy) / step * change[t][k];
    // A map that is shifted by whole bins has the same energy, whatever rounding says.
    const bool better = energy < result.energy - 1e-12;
    step = better ? std::fmin(1, 1.3 * step) : std::fmax(0.02, 0.9 * step);
    if (!better)
      continue;
    actions = tried;
    result.energy = energy;
    ++result.accepted;
  }
  actions[0] = actionsOf(map.poses)[0];
  result.poses = pathOf(actions);
  return result;
}

} // namespace pcl::acmap::test
