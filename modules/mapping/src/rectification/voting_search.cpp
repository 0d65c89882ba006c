#include "rectification_steps.h"

#include "ray_evidence.h"

#include <pcl/core/random.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {
namespace {

const Eigen::Array3d unit_step(0.05, 0.05, 0.02); ///< m, m, rad
constexpr double probe_spread = 0.5; ///< standard deviation of a probe, in steps
constexpr double memory = 0.7;       ///< weight of the previous vote
constexpr double full_effect = 0.02; ///< bits that result in a full vote
constexpr double growth = 1.3, decay = 0.9, min_step = 0.04;
constexpr int probes_a_round = 40;
constexpr int evaluations_a_pose = 50; ///< for all levels

/** State of the search for one action. */
struct ActionVotes {
  Eigen::Array3d vote = Eigen::Array3d::Zero(); ///< in [-1, 1], towards lower energy
  double step = 1;
};

class VotingSearch {
public:
  VotingSearch(const std::vector<PlanarPose>& poses,
               std::uint64_t seed,
               const Progress& progress,
               EntropyRectificationReport& report)
  : start_(actionBetween({}, poses.front()))
  , actions_{start_}
  , voters_(poses.size())
  , random_(seed)
  , progress_(progress)
  , report_(report)
  {
    for (std::size_t t = 1; t < poses.size(); ++t)
      actions_.push_back(actionBetween(poses[t - 1], poses[t]));
  }

  void
  run(MapEntropyEvaluator& evaluator, double bin_size, std::size_t evaluations)
  {
    evaluator_ = &evaluator;
    std::fill(voters_.begin(), voters_.end(), ActionVotes());
    energy_ = energyOf(actions_);
    if (std::isinf(energy_))
      return;
    const std::size_t end = evaluations_ + evaluations;
    std::size_t idle = 0; // probes since the last accepted move
    while (evaluations_ < end && idle < 4 * actions_.size()) {
      for (int i = 0; i < probes_a_round; ++i)
        idle = probe() ? 0 : idle + 1;
      if (moveTogether())
        idle = 0;
      progress_.tell(shareDone(), "voting");
      report_.steps.push_back({"voting", bin_size, energy_, 0, energy_});
    }
  }

  /** The result, with the first pose as it was given. */
  std::vector<PlanarPose>
  poses() const
  {
    Actions actions = actions_;
    actions.front() = start_;
    return posesOf(actions);
  }

  std::size_t
  evaluations() const
  {
    return evaluations_;
  }

private:
  double
  shareDone() const
  {
    const auto all = static_cast<double>(evaluations_a_pose * voters_.size());
    return std::min(1.0, static_cast<double>(evaluations_) / all);
  }

  using Actions = std::vector<PlanarAction>;

  static std::vector<PlanarPose>
  posesOf(const Actions& actions)
  {
    std::vector<PlanarPose> poses;
    for (const PlanarAction& action : actions) {
      poses.push_back(moved(poses.empty() ? PlanarPose() : poses.back(), action));
      poses.back().theta = std::remainder(poses.back().theta, 2 * M_PI); // many turns
    }
    return poses;
  }

  double
  energyOf(const Actions& actions)
  {
    ++evaluations_;
    MapEntropyReport ignored;
    const MapEntropyTerms terms = evaluator_->evaluate(posesOf(actions), ignored);
    return terms.points ? terms.total : INFINITY;
  }

  static void
  change(PlanarAction& action, const Eigen::Array3d& by)
  {
    action.dx += by[0];
    action.dz += by[1];
    action.dtheta += by[2];
  }

  /** Changes one action and updates its vote. \return whether the energy decreased */
  bool
  probe()
  {
    const auto t = static_cast<std::size_t>(
        random_.uniform(0, static_cast<double>(actions_.size())));
    ActionVotes& voter = voters_[t];
    Eigen::Array3d d;
    for (double& part : d)
      part = probe_spread * random_.normal();
    if (random_.uniform() < 0.5)
      d = d / 2 + voter.vote;
    Actions tried = actions_;
    change(tried[t], voter.step * unit_step * d);
    const double energy = energyOf(tried);
    const double effect = energy - energy_;
    const double strength = std::min(1.0, std::abs(effect) / full_effect);
    const double size = d.matrix().norm();
    if (size > 0 && effect != 0)
      voter.vote =
          memory * voter.vote + (1 - memory) * strength * (effect < 0 ? d : -d) / size;
    const bool better = effect < 0;
    voter.step = better ? std::min(1.0, growth * voter.step)
                        : std::max(min_step, decay * voter.step);
    if (better) {
      actions_ = std::move(tried);
      energy_ = energy;
    }
    return better;
  }

  /** The paper's move: half of the actions are changed at once, each by its vote. */
  bool
  moveTogether()
  {
    std::vector<std::size_t> chosen;
    for (std::size_t t = 0; t < actions_.size(); ++t)
      if (random_.uniform() < 0.5)
        chosen.push_back(t);
    for (const double share : {1.0, 0.4, 0.16}) {
      Actions tried = actions_;
      for (const std::size_t t : chosen)
        change(tried[t], share * voters_[t].step * unit_step * voters_[t].vote);
      const double energy = energyOf(tried);
      if (energy < energy_) {
        actions_ = std::move(tried);
        energy_ = energy;
        return true;
      }
    }
    return false;
  }

  PlanarAction start_;
  Actions actions_; ///< the first one is the first pose: it turns the map
  std::vector<ActionVotes> voters_;
  Random random_;
  const Progress& progress_;
  EntropyRectificationReport& report_;
  MapEntropyEvaluator* evaluator_ = nullptr;
  double energy_ = 0;
  std::size_t evaluations_ = 0;
};

} // namespace

std::vector<PlanarPose>
votingSearch(const RectificationTask& task,
             EntropySearch& search,
             const std::vector<PlanarPose>& poses)
{
  EntropyRectificationReport& report = task.report;
  VotingSearch voting(poses, task.settings.seed, task.progress, report);
  for (const double factor : {4.0, 2.0, 1.0}) {
    const EntropyLevel level{factor * task.settings.bin_size, 1, false, false};
    MapEntropyEvaluator evaluator(search.cells(level), search.entropySettings(level));
    voting.run(evaluator, level.bin_size, evaluations_a_pose * poses.size() / 3);
  }
  report.evaluations += voting.evaluations();
  report.outcome = RectificationOutcome::Rectified;
  report.reason = "the entropy fell; paper mode asks nothing else";
  const RayEvidence rays(task.observations, task.settings.bin_size);
  rays.judge(poses, report.before);
  rays.judge(voting.poses(), report.after);
  measureQuality(task.observations, poses, report.before);
  measureQuality(task.observations, voting.poses(), report.after);
  return voting.poses();
}

} // namespace pcl::acmap
