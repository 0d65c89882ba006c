#include <pcl/core/exceptions.h>
#include <pcl/stereo/disparity_fusion.h>

#include "fusion/fused_shots.h"
#include "fusion/observation.h"
#include "matching/shot_check.h"

#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/parallel.h>

#include <algorithm>
#include <optional>

namespace pcl {

using acmap::Observation;

struct DisparityFusion::State {
  std::optional<TrinocularRig> rig;
  TrinocularMatching matching;
  Method method = Method::SpaceTime;
  int minimum_support = 3;
  bool passive = false;
  double min_gain = 0.005;
  unsigned threads = 0;
  ProgressCallback progress;
  DisparityFusionReport report;
  std::optional<Observation> observation; // exists as soon as the rig is set

  Observation&
  requireObservation()
  {
    if (!observation)
      throw acmap::InitFailed("DisparityFusion has no rig");
    return *observation;
  }

  void
  forget()
  {
    if (rig)
      observation.emplace(*rig);
  }

  /** \brief Minimum standard deviation of the grey levels of a covered pixel. */
  double
  leastDeviation() const
  {
    constexpr double default_deviation = 2.0; // as in the matching
    return std::max(default_deviation, matching.getPeakFilter().value_or(0.0));
  }

  MatchedDisparity
  fuseFrames(Report& told)
  {
    MatchedDisparity fused;
    matching.match(observation->frames, fused);
    told = matching.getReport();
    return fused;
  }

  /** Matches the first shot without a pattern; the others would add no information. */
  MatchedDisparity
  matchPassively(DisparityFusionReport& told)
  {
    MatchedDisparity matched;
    matching.match(*observation->first_dark, matched);
    static_cast<Report&>(told) = matching.getReport();
    told.is_passive = true;
    if (told.off_shots > 1)
      told.remarks.push_back("there is no shot with a pattern: of " +
                             std::to_string(told.off_shots) +
                             " shots without one, only the first was matched");
    return matched;
  }

  MatchedDisparity
  fuseMatched(Report& told) const
  {
    const acmap::Progress shown(progress);
    shown.tell(0.0, "fusion");
    told.seconds.emplace_back("matching", observation->matching_seconds);
    acmap::StepTimer timer(told);
    const auto statistic = method == Method::Median
                               ? acmap::ShotStatistic::Median
                               : acmap::ShotStatistic::ConsistentMean;
    const std::size_t minimum = std::min(static_cast<std::size_t>(minimum_support),
                                         observation->matched.size());
    MatchedDisparity fused = acmap::withThreads(threads, [&] {
      return acmap::fuseShots(observation->matched, statistic, minimum);
    });
    timer.finish("fusion");
    shown.tell(1.0, "fusion");
    return fused;
  }
};

DisparityFusion::DisparityFusion()
: state_(std::make_unique<State>())
{}
DisparityFusion::~DisparityFusion() = default;
DisparityFusion::DisparityFusion(DisparityFusion&&) noexcept = default;
DisparityFusion&
DisparityFusion::operator=(DisparityFusion&&) noexcept = default;

void
DisparityFusion::setInputRig(const TrinocularRig& rig)
{
  state_->matching.setInputRig(rig);
  state_->rig = rig;
  state_->forget();
}

void
DisparityFusion::setMatching(const TrinocularMatching& matching)
{
  TrinocularMatching own = matching;
  if (state_->rig)
    own.setInputRig(*state_->rig);
  own.setNumberOfThreads(state_->threads);
  own.setProgressCallback(state_->progress);
  state_->matching = own;
  state_->forget();
}

const TrinocularMatching&
DisparityFusion::getMatching() const
{
  return state_->matching;
}

void
DisparityFusion::setMethod(Method method)
{
  if (method == state_->method)
    return;
  state_->method = method;
  state_->forget();
}

DisparityFusion::Method
DisparityFusion::getMethod() const
{
  return state_->method;
}

void
DisparityFusion::setMinimumSupport(int shots)
{
  acmap::requireInRange("minimum support", shots, 1, acmap::max_shots, "shots");
  state_->minimum_support = shots;
}

int
DisparityFusion::getMinimumSupport() const
{
  return state_->minimum_support;
}

void
DisparityFusion::setPassive(bool passive)
{
  state_->passive = passive;
}

bool
DisparityFusion::getPassive() const
{
  return state_->passive;
}

void
DisparityFusion::setLeastGain(double share)
{
  acmap::requireInRange("minimum gain", share, 0.0, 1.0, "of the pixels");
  state_->min_gain = share;
}

double
DisparityFusion::getLeastGain() const
{
  return state_->min_gain;
}

void
DisparityFusion::setNumberOfThreads(unsigned threads)
{
  state_->threads = acmap::requiredThreads(threads);
  state_->matching.setNumberOfThreads(threads);
}

unsigned
DisparityFusion::getNumberOfThreads() const
{
  return state_->threads;
}

void
DisparityFusion::setProgressCallback(ProgressCallback callback)
{
  state_->progress = callback;
  state_->matching.setProgressCallback(std::move(callback));
}

void
DisparityFusion::clear()
{
  state_->forget();
}

void
DisparityFusion::addShot(const TrinocularFrame::ConstPtr& shot)
{
  Observation& observation = state_->requireObservation();
  if (!shot)
    throw acmap::BadArgument("the shot is null");
  acmap::requireShotOf(*state_->rig, *shot);
  if (observation.shots() == acmap::max_shots)
    throw acmap::BadArgument("an observation has at most " +
                             std::to_string(acmap::max_shots) + " shots");
  const CameraImage& reference = shot->image(RigCamera::Reference);
  if (shot->pattern == TrinocularFrame::no_pattern) {
    acmap::withThreads(state_->threads, [&] { observation.addDark(shot); });
    return;
  }
  if (state_->method == Method::SpaceTime)
    observation.frames.push_back(shot);
  else {
    MatchedDisparity matched;
    state_->matching.match(*shot, matched);
    observation.addMatched(std::move(matched), state_->matching.getReport());
  }
  acmap::withThreads(state_->threads,
                     [&] { observation.addLit(reference, state_->leastDeviation()); });
}

std::size_t
DisparityFusion::shots() const
{
  return state_->observation ? state_->observation->shots() : 0;
}

bool
DisparityFusion::wantsAnotherShot() const
{
  constexpr std::size_t min_known = 3; // two shots may differ little by chance
  if (shots() == 0)
    return true;
  if (shots() == acmap::max_shots)
    return false;
  const std::vector<double>& coverage = state_->observation->coverage();
  return coverage.size() < min_known ||
         coverage.back() - coverage[coverage.size() - 2] > state_->min_gain;
}

void
DisparityFusion::fuse(MatchedDisparity& fused)
{
  const Observation& from = state_->requireObservation();
  DisparityFusionReport report;
  report.shots = from.litShots();
  report.off_shots = from.darkShots();
  MatchedDisparity result;
  if (report.shots == 0 && report.off_shots > 0 && state_->passive)
    result = state_->matchPassively(report);
  else if (report.shots == 0) {
    result = acmap::noDisparity(
        state_->rig->width, state_->rig->height, DisparityOutcome::TooFewShots);
    report.remarks.emplace_back("there is no shot with a pattern: no disparities");
  }
  else if (state_->method == Method::SpaceTime)
    result = state_->fuseFrames(report);
  else
    result = state_->fuseMatched(report);
  if (report.shots > 0 && report.off_shots == 0)
    report.remarks.emplace_back(
        "there is no shot without a pattern: the colour has the patterns' light in it");
  report.outcomes = countOutcomes(result);
  if (state_->method != Method::SpaceTime && report.shots > 0 &&
      report.outcomes[0] == 0)
    report.remarks.emplace_back("no pixel was matched");
  fused = std::move(result);
  state_->report = std::move(report);
}

DisparityFusion
DisparityFusion::release()
{
  std::optional<Observation> shots = std::move(state_->observation);
  state_->observation.reset();
  DisparityFusion released;
  *released.state_ = *state_;
  released.setProgressCallback({});
  released.state_->observation = std::move(shots);
  state_->forget();
  return released;
}

CameraImage
DisparityFusion::getColor() const
{
  return state_->observation ? state_->observation->color() : CameraImage{};
}

DisparityFusionReport
DisparityFusion::getReport() const
{
  DisparityFusionReport report = state_->report;
  if (state_->observation)
    report.coverage = state_->observation->coverage();
  return report;
}

DisparityFusion::Method
disparityFusionMethod(const std::string& name)
{
  using Method = DisparityFusion::Method;
  if (name == "median")
    return Method::Median;
  if (name == "statistical")
    return Method::Statistical;
  if (name == "spacetime")
    return Method::SpaceTime;
  throw acmap::BadArgument("\"" + name +
                           "\" is no method of fusion; legal are median, "
                           "statistical and spacetime");
}

} // namespace pcl
