#include "joined_landmarks.h"
#include "landmark_solver.h"
#include "odometry_prior.h"
#include "plane_landmarks.h"
#include "pose_system.h"
#include "ray_contradictions.h"
#include "revisit_links.h"
#include "surface_floor.h"
#include "view_pieces.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/length_remarks.h>
#include <pcl/core/impl/quantile.h>
#include <pcl/mapping/impl/plane_adjustment_kernel.h>

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace pcl::acmap {
namespace {

using Pair = PoseSystem::Pair;

constexpr std::size_t max_rounds = 14;
constexpr std::size_t steps_per_round = 3;
constexpr std::size_t first_joined_round = 4;
constexpr double last_gate = 0.5;     // metres
constexpr double still = 0.0003;      // metres: a round that moves less is the last one
constexpr double degree = M_PI / 180; // radians

/** Inverse of the normal equations at some poses, with all \a pairs in its pattern. */
PoseSystem
covarianceAt(const Poses& poses,
             const OdometryPrior& prior,
             const RevisitLinks& links,
             const std::vector<Landmark>& landmarks,
             const std::vector<Pair>& pairs)
{
  std::vector<Pair> rows = connectedRows(landmarks, poses.size());
  for (const auto& [a, b] : pairs)
    if (a > 0)
      rows.emplace_back(a - 1, b - 1);
  links.addPairs(rows);
  PoseSystem system(poses.size() - 1, rows);
  std::vector<Vector6> gradient(poses.size() - 1, Vector6::Zero());
  const auto linearize = [&] {
    prior.linearize(poses, system, gradient);
    links.linearize(poses, system, gradient);
    linearizeLandmarks(poses, landmarks, system, gradient);
  };
  linearize();
  for (double damping = 1e-9; !system.factorize(); damping *= 100) {
    system.setZero();
    linearize();
    system.damp(damping);
    if (damping > 1)
      break;
  }
  system.invert();
  return system;
}

/** The 80 % quantile of the standard deviation of a piece relative to the view before
 * or after it. */
double
neighbourDeviation(const PiecesOfViews& pieces,
                   const Poses& poses,
                   const RelativeCovariances& covariances)
{
  constexpr std::size_t pieces_per_view = 64;
  constexpr double share = 0.8;
  std::vector<double> deviations;
  for (std::size_t view = 0; view + 1 < poses.size(); ++view)
    for (const auto& entry : covariances.of(view)) {
      if (entry.other != view + 1)
        continue;
      const std::vector<PlanePiece>& seen = pieces[entry.other];
      for (std::size_t i = 0; i < seen.size(); i += 1 + seen.size() / pieces_per_view)
        deviations.push_back(
            deviationAcross(covariances.at(entry.place),
                            poses[entry.other] * seen[i].center -
                                poses[covariances.origin(entry.place)].translation(),
                            poses[entry.other].linear() * seen[i].normal));
    }
  return quantileOf(deviations, share);
}

constexpr std::size_t enough_rays = 50;
constexpr double usual_contradictions = 0.01; // of the rays, in right maps

/** Is a share of contradicted rays clearly larger than before? */
bool
isWorse(std::size_t rays_before, double before, std::size_t rays_after, double after)
{
  return rays_after >= enough_rays && after > before + usual_contradictions &&
         after * static_cast<double>(rays_after) >
             1.2 * before * static_cast<double>(rays_before);
}

/** Decides from the evidence in a report. */
void
decide(PlaneAdjustmentReport& report)
{
  constexpr double significant = 5;
  const RayContradictions& before = report.rays_before;
  const RayContradictions& after = report.rays_after;
  if (report.significance < significant) {
    report.outcome = AdjustmentOutcome::Kept;
    report.reason = "the planes fit the given poses within noise";
  }
  else if (isWorse(before.near_rays,
                   before.near_share,
                   after.near_rays,
                   after.near_share) ||
           isWorse(
               before.far_rays, before.far_share, after.far_rays, after.far_share)) {
    report.outcome = AdjustmentOutcome::Refused;
    report.reason = "rays contradict the adjusted poses more than the given ones";
    report.remarks.push_back(report.reason);
  }
  else if (after.far_rays >= enough_rays &&
           after.far_share > after.near_share + 2 * usual_contradictions) {
    report.outcome = AdjustmentOutcome::Refused;
    report.reason = "views of one place from different times contradict each other";
    report.remarks.push_back(report.reason);
  }
  else {
    report.outcome = AdjustmentOutcome::Adjusted;
    report.reason =
        std::to_string(report.landmarks) + " planes are seen from several views";
  }
}

/** Settings of one of several attempts. */
struct AttemptSettings : PlaneAdjustmentSettings {
  AttemptSettings(const PlaneAdjustmentSettings& settings, double share)
  : PlaneAdjustmentSettings(settings)
  , annealing(share)
  {}

  double annealing; ///< systematic error of the first round, as a share of the
                    ///< uncertainty of neighbouring views
};

/** The rounds of an adjustment. */
class PlaneAdjuster {
public:
  PlaneAdjuster(const PiecesOfViews& pieces,
                const Poses& given,
                const AttemptSettings& settings,
                const Progress& progress,
                PlaneAdjustmentReport& report)
  : pieces_(pieces)
  , poses_(given)
  , prior_(given, settings)
  , links_(settings.revisits)
  , settings_(settings)
  , progress_(progress)
  , report_(report)
  {}

  /** \return false if no plane is seen from two views */
  bool
  run()
  {
    if (links_.used() > 0)
      closeLoops();
    double gate = 0;
    for (std::size_t round = 0; round < max_rounds; ++round) {
      progress_.tell(0.3 + 0.6 * static_cast<double>(round) / max_rounds, "adjust");
      const std::vector<Pair> pairs = overlappingViews(pieces_, poses_);
      const PoseSystem inverse = covarianceAt(poses_, prior_, links_, joined_, pairs);
      if (settings_.estimate_odometry && round >= 3)
        prior_.rescale(poses_, prior_.covariances(poses_, inverse));
      const RelativeCovariances relative(inverse, poses_, pairs);
      const double deviation = neighbourDeviation(pieces_, poses_, relative);
      if (round == 0)
        gate = std::min(last_gate, std::max(0.05, 3.15 * deviation));
      AssociationGate association;
      association.distance = gate;
      association.inner = round == 0 ? 1 : 3;
      association.angle =
          (12 - 7 * std::min(1.0, static_cast<double>(round) / 3)) * degree;
      floor_.minimum = std::max(SurfaceFloor::min_constant,
                                settings_.annealing * deviation *
                                    std::pow(0.5, static_cast<double>(round)));
      association.floor = floor_;
      landmarks_ = findLandmarks(pieces_, poses_, relative, association);
      if (landmarks_.empty())
        break;
      joined_ =
          round >= first_joined_round ? joinLandmarks(landmarks_, poses_) : landmarks_;
      const double moved = minimize(prior_, links_, steps_per_round, joined_, poses_);
      links_.dropContradicted(poses_);
      fitLandmarks(poses_, landmarks_);
      floor_ = measureFloor(landmarks_, poses_, floor_);
      tellRound(gate, moved);
      if (gate >= last_gate && moved < still)
        break;
      gate = std::min(last_gate, 1.6 * gate);
    }
    return !landmarks_.empty();
  }

  const Poses&
  poses() const
  {
    return poses_;
  }

  /** Compares the adjusted poses with the given ones, and tells their uncertainty. */
  void
  judge(const Poses& given)
  {
    const PoseSystem inverse = covarianceAt(poses_, prior_, links_, joined_, {});
    double determined = static_cast<double>(6 * prior_.actions());
    const std::vector<Matrix6> actions = prior_.covariances(poses_, inverse);
    for (std::size_t i = 0; i < actions.size(); ++i)
      determined -= prior_.shareOf(i, actions[i]);
    double free = -determined;
    for (const Landmark& landmark : landmarks_)
      free += 3 * static_cast<double>(landmark.views.size() - 1);
    std::vector<Landmark> at_given = landmarks_;
    const double before = fitLandmarks(given, at_given);
    const double after = fitLandmarks(poses_, landmarks_);
    // Errors of the sensor that its noise does not describe count as noise.
    const double unit = std::max(1.0, free > 0 ? after / free : 1.0);
    determined = std::max(1.0, determined);
    report_.significance =
        ((before - after) / unit - determined) / std::sqrt(2 * determined);
    report_.thickness_before = thicknessOf(at_given, given);
    report_.thickness_after = thicknessOf(landmarks_, poses_);
    report_.landmarks = landmarks_.size();
    report_.revisits_used = links_.used();
    for (const Landmark& landmark : landmarks_)
      report_.associated_pieces += landmark.pieces;
    report_.prior = prior_.cost(poses_) / static_cast<double>(6 * prior_.actions());
    report_.odometry_factors = {prior_.factors()[0], prior_.factors()[1]};
    SurfaceFloor floor = floor_;
    floor.minimum = 0;
    report_.floor = std::sqrt(floor.variance(2));
    report_.uncertainty.assign(poses_.size(), {});
    for (std::size_t view = 1; view < poses_.size(); ++view) {
      const Matrix6 covariance = inverse.inverse(view - 1, view - 1);
      report_.uncertainty[view] = {
          std::sqrt(covariance.bottomRightCorner<3, 3>().trace()),
          std::sqrt(covariance.topLeftCorner<3, 3>().trace())};
    }
  }

private:
  /** Lets the views of revisits overlap before planes are associated. */
  void
  closeLoops()
  {
    constexpr std::size_t steps = 20;
    links_.dropImplausible(
        poses_, covarianceAt(poses_, prior_, RevisitLinks({}), {}, linkedViews()));
    const Poses given = poses_;
    do {
      poses_ = given;
      minimize(prior_, links_, steps, landmarks_, poses_);
    } while (links_.dropContradicted(poses_));
  }

  /** The pairs of views of the revisits. */
  std::vector<Pair>
  linkedViews() const
  {
    std::vector<Pair> pairs;
    for (const RevisitConstraint& revisit : settings_.revisits)
      pairs.emplace_back(revisit.earlier, revisit.later);
    return pairs;
  }

  void
  tellRound(double gate, double moved)
  {
    AdjustmentRound round;
    round.gate = gate;
    round.floor = std::sqrt(floor_.variance(2));
    round.landmarks = landmarks_.size();
    for (const Landmark& landmark : landmarks_)
      round.pieces += landmark.pieces;
    round.prior = prior_.cost(poses_) / static_cast<double>(6 * prior_.actions());
    round.thickness = thicknessOf(landmarks_, poses_);
    round.moved = moved;
    report_.rounds.push_back(round);
  }

  const PiecesOfViews& pieces_;
  Poses poses_;
  OdometryPrior prior_;
  RevisitLinks links_;
  const AttemptSettings& settings_;
  const Progress& progress_;
  PlaneAdjustmentReport& report_;
  std::vector<Landmark> landmarks_;
  std::vector<Landmark> joined_; ///< those that continue each other as one
  SurfaceFloor floor_;
};

/** A result of an adjustment. */
struct Attempt {
  Poses poses; ///< the given ones unless the outcome is Adjusted
  PlaneAdjustmentReport report;

  /** The larger share of contradicted rays. */
  double
  contradicted() const
  {
    const RayContradictions& rays = report.rays_after;
    return std::max(rays.near_rays >= enough_rays ? rays.near_share : 0,
                    rays.far_rays >= enough_rays ? rays.far_share : 0);
  }

  /** Are more rays contradicted than in right maps, or nearly as many, although the
   * odometry had to be distrusted? */
  bool
  isDoubtful() const
  {
    constexpr double distrust = 2;
    const auto& factors = report.odometry_factors;
    const bool is_distrusted = std::max(factors[0], factors[1]) > distrust;
    return contradicted() > (is_distrusted ? 0.5 : 1.0) * usual_contradictions;
  }
};

Attempt
adjusted(const PiecesOfViews& pieces,
         const Poses& given,
         const AttemptSettings& settings,
         const Progress& progress,
         const PlaneAdjustmentReport& before)
{
  Attempt attempt{given, before};
  PlaneAdjustmentReport& report = attempt.report;
  PlaneAdjuster adjuster(pieces, given, settings, progress, report);
  if (!adjuster.run()) {
    report.reason = "no plane is seen from two views";
    report.remarks.push_back(report.reason);
    return attempt;
  }
  progress.tell(0.9, "judge");
  adjuster.judge(given);
  report.rays_after = contradictionsOf(pieces, adjuster.poses());
  decide(report);
  if (report.outcome == AdjustmentOutcome::Adjusted)
    attempt.poses = adjuster.poses();
  return attempt;
}

/** The first attempt, and what else is tried where its result is doubtful: an early wrong
 * association can be so strong that the odometry is distrusted rather than undone. */
std::vector<AttemptSettings>
attemptsOf(const PlaneAdjustmentSettings& settings)
{
  constexpr double usual = 0.2, longer = 0.5; // of the uncertainty of neighbours
  std::vector<AttemptSettings> attempts{{settings, usual}};
  AttemptSettings trusting{settings, usual};
  trusting.estimate_odometry = false;
  if (settings.estimate_odometry)
    attempts.push_back(trusting);
  trusting.annealing = longer;
  attempts.push_back(trusting);
  if (!settings.revisits.empty()) {
    attempts.push_back(attempts.front());
    attempts.back().revisits.clear();
  }
  return attempts;
}

/** The attempt that rays contradict least. */
Attempt
bestAttempt(const PiecesOfViews& pieces,
            const Poses& given,
            const PlaneAdjustmentSettings& settings,
            const Progress& progress,
            const PlaneAdjustmentReport& before)
{
  Attempt best{given, before};
  std::size_t count = 0;
  for (const AttemptSettings& way : attemptsOf(settings)) {
    Attempt attempt = adjusted(pieces, given, way, progress, before);
    attempt.report.revisits_dropped =
        settings.revisits.size() - attempt.report.revisits_used;
    if (count == 0 ||
        (attempt.report.landmarks > 0 && attempt.contradicted() < best.contradicted()))
      best = std::move(attempt);
    ++count;
    if (!best.isDoubtful())
      break;
  }
  best.report.attempts = count;
  return best;
}

void
requireViews(const std::vector<RevisitConstraint>& revisits, std::size_t views)
{
  for (const RevisitConstraint& revisit : revisits)
    if (revisit.earlier >= revisit.later || revisit.later >= views)
      throw acmap::BadArgument("there are no views " + std::to_string(revisit.earlier) +
                               " and " + std::to_string(revisit.later) + " among " +
                               std::to_string(views) + ", the earlier one first");
}

} // namespace

std::vector<Eigen::Isometry3d>
adjustPlanes(const AdjustedViewReader& read,
             const std::vector<Eigen::Isometry3d>& poses,
             const PlaneAdjustmentSettings& settings,
             const Progress& progress,
             PlaneAdjustmentReport& report)
{
  if (!settings.action_covariances.empty() &&
      settings.action_covariances.size() + 1 != poses.size())
    throw acmap::BadArgument("each action needs one covariance");
  requireViews(settings.revisits, poses.size());
  StepTimer timer(report);
  report.views = poses.size();
  progress.tell(0, "measure noise");
  const RangeNoise noise = measureRangeNoise(read, poses.size());
  progress.tell(0.1, "cut");
  PiecesOfViews pieces(poses.size());
  std::vector<PieceCounts> counts(poses.size());
  oneapi::tbb::parallel_for(std::size_t{0}, poses.size(), [&](std::size_t i) {
    read(i, [&](const AdjustedView& view) {
      pieces[i] = piecesOf(view, noise, counts[i]);
      if (i == 0)
        addRemarks(report, lengthRemarks(view.points));
    });
  });
  for (std::size_t i = 0; i < poses.size(); ++i) {
    report.points += counts[i].points;
    report.invalid_points += counts[i].invalid_points;
    report.pieces += pieces[i].size();
  }
  constexpr double typical = 2; // metres
  report.noise_factor = noise.sigma(typical, 1);
  timer.finish("cut");
  std::vector<Eigen::Isometry3d> result = poses;
  report.moved.assign(poses.size(), 0);
  report.turned.assign(poses.size(), 0);
  if (poses.size() < 2) {
    report.reason = "one view: there is nothing that it could fit or not fit";
    report.remarks.push_back(report.reason);
    return result;
  }
  report.rays_before = contradictionsOf(pieces, poses);
  Attempt best = bestAttempt(pieces, poses, settings, progress, report);
  result = std::move(best.poses);
  report = std::move(best.report);
  timer.finish("adjust");
  for (std::size_t i = 0; i < poses.size(); ++i) {
    report.moved[i] = (result[i].translation() - poses[i].translation()).norm();
    report.turned[i] =
        Eigen::AngleAxisd(poses[i].linear().transpose() * result[i].linear()).angle();
  }
  return result;
}

} // namespace pcl::acmap
