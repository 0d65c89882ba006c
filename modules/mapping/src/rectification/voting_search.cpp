#include "rectification_steps.h"

#include "entropy/exact_entropy.h"
#include "ray_evidence.h"

#include <pcl/core/random.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap {
namespace {

// The paper gives neither of these.
const Eigen::Array3d unit_step(0.05, 0.05, 0.02); ///< m, m, rad
constexpr double share_of_actions = 0.5; ///< probability that a vote changes an action
constexpr double random_part = 0.5;      ///< standard deviation, in steps
constexpr double memory = 0.9;           ///< weight of the earlier effects of an action
constexpr double growth = 1.3, decay = 0.9, min_step = 0.02;
constexpr std::size_t votes_a_round = 40, votes_a_pose = 50;

using Actions = std::vector<PlanarAction>;

/** p_0 = a_0, p_t = p_{t-1} (+) a_t */
std::vector<PlanarPose>
posesOf(const Actions& actions)
{
  std::vector<PlanarPose> poses;
  for (const PlanarAction& action : actions) {
    poses.push_back(moved(poses.empty() ? PlanarPose() : poses.back(), action));
    poses.back().theta = std::remainder(poses.back().theta, 2 * M_PI); // many turns
  }
  return poses;
}

std::vector<PosedPoints>
pointsOf(const std::vector<LevelledPoints>& observations)
{
  std::vector<PosedPoints> all;
  for (const LevelledPoints& seen : observations) {
    PosedPoints points;
    if (!seen.points.empty())
      points.points =
          PointView(seen.points.data(), sizeof(seen.points[0]), seen.points.size());
    points.weights = seen.weights.empty() ? nullptr : seen.weights.data();
    all.push_back(points);
  }
  return all;
}

MapEntropySettings
entropyOf(const RectificationSettings& settings)
{
  MapEntropySettings entropy;
  entropy.bin_size = settings.bin_size;
  entropy.smoothing = settings.smoothing.value_or(settings.bin_size);
  entropy.projection_weight = projectionWeight(settings);
  return entropy;
}

class VotingSearch {
public:
  VotingSearch(const RectificationTask& task, const std::vector<PlanarPose>& poses)
  : task_(task)
  , evaluator_(pointsOf(task.observations), entropyOf(task.settings), Progress())
  , start_(actionBetween({}, poses.front()))
  , actions_{start_}
  , effects_(poses.size(), Eigen::Array3d::Zero())
  , random_(task.settings.seed)
  {
    for (std::size_t t = 1; t < poses.size(); ++t)
      actions_.push_back(actionBetween(poses[t - 1], poses[t]));
  }

  /** \return reason why there is no entropy, if so */
  std::string
  run()
  {
    EntropyRectificationReport& report = task_.report;
    MapEntropyReport told;
    energy_ = energyOf(actions_, told);
    if (std::isinf(energy_))
      return told.remarks.front();
    evaluator_.keep();
    const std::size_t maximum = votes_a_pose * actions_.size();
    while (report.votes < maximum) {
      vote();
      task_.progress.tell(
          static_cast<double>(report.votes) / static_cast<double>(maximum), "voting");
      if (report.votes % votes_a_round == 0)
        tellStep();
    }
    if (report.votes % votes_a_round != 0)
      tellStep();
    return "";
  }

  /** The result, with the first pose as it was given. */
  std::vector<PlanarPose>
  poses() const
  {
    Actions actions = actions_;
    actions.front() = start_;
    return posesOf(actions);
  }

private:
  void
  tellStep()
  {
    task_.report.steps.push_back(
        {"voting", task_.settings.bin_size, energy_, 0, energy_});
  }

  double
  energyOf(const Actions& actions, MapEntropyReport& told)
  {
    ++task_.report.evaluations;
    const MapEntropyTerms terms = evaluator_.evaluate(posesOf(actions), told);
    return terms.points ? terms.total : std::numeric_limits<double>::infinity();
  }

  /** Draws at least two actions. */
  std::vector<std::size_t>
  drawSubset()
  {
    std::vector<std::size_t> subset;
    while (subset.size() < 2) {
      subset.clear();
      for (std::size_t t = 0; t < actions_.size(); ++t)
        if (random_.uniform() < share_of_actions)
          subset.push_back(t);
    }
    return subset;
  }

  /** Root mean square of the effects of all actions. */
  double
  sizeOfEffects() const
  {
    double sum = 0;
    for (const Eigen::Array3d& effect : effects_)
      sum += effect.square().sum();
    return std::sqrt(sum / (3 * static_cast<double>(actions_.size())));
  }

  /** Changes a subset of the actions at once, each in proportion to its previous effect
   * on the energy. */
  void
  vote()
  {
    ++task_.report.votes;
    const std::vector<std::size_t> subset = drawSubset();
    const double size = sizeOfEffects();
    Actions tried = actions_;
    std::vector<Eigen::Array3d> changes(actions_.size()); // in steps
    for (const std::size_t t : subset) {
      for (double& part : changes[t])
        part = random_part * random_.normal();
      if (size > 0)
        changes[t] -= effects_[t] / size;
      const Eigen::Array3d change = step_ * unit_step * changes[t];
      tried[t].dx += change[0];
      tried[t].dz += change[1];
      tried[t].dtheta += change[2];
    }
    MapEntropyReport ignored;
    const double energy = energyOf(tried, ignored);
    if (std::isfinite(energy))
      for (const std::size_t t : subset)
        effects_[t] = memory * effects_[t] +
                      (1 - memory) * ((energy - energy_) / step_) * changes[t];
    const bool is_better = energy < energy_;
    step_ =
        is_better ? std::min(1.0, growth * step_) : std::max(min_step, decay * step_);
    if (is_better) {
      actions_ = std::move(tried);
      energy_ = energy;
      evaluator_.keep();
      ++task_.report.accepted_moves;
    }
  }

  const RectificationTask& task_;
  ExactEntropyEvaluator evaluator_;
  PlanarAction start_;
  Actions actions_; ///< the first one is the first pose: it turns the map
  std::vector<Eigen::Array3d> effects_; ///< of each action: energy times change, mean
  Random random_;
  double energy_ = 0;
  double step_ = 1; ///< in unit steps
};

} // namespace

std::vector<PlanarPose>
votingSearch(const RectificationTask& task, const std::vector<PlanarPose>& poses)
{
  EntropyRectificationReport& report = task.report;
  VotingSearch voting(task, poses);
  report.reason = voting.run();
  measureQuality(task.observations, poses, report.before);
  if (!report.reason.empty())
    return poses;
  const bool has_moved = report.accepted_moves > 0;
  report.outcome =
      has_moved ? RectificationOutcome::Rectified : RectificationOutcome::Kept;
  report.reason = has_moved ? "the entropy fell; paper mode asks nothing else"
                            : "no vote lowered the entropy";
  const RayEvidence rays(task.observations, task.settings.bin_size);
  rays.judge(poses, report.before);
  rays.judge(voting.poses(), report.after);
  measureQuality(task.observations, voting.poses(), report.after);
  return voting.poses();
}

} // namespace pcl::acmap
