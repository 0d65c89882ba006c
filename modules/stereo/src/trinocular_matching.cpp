#include <pcl/core/exceptions.h>
#include <pcl/stereo/trinocular_matching.h>

#include "matching/joined_pairs.h"
#include "matching/pair_match.h"
#include "matching/shot_check.h"

#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/rig_cameras.h>

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pcl {

namespace {

using Shots = std::vector<const TrinocularFrame*>;

/** Returns the shots under a pattern; if there are none, the first shot, because
 * further shots add no information. */
Shots
shotsToMatch(const std::vector<TrinocularFrame::ConstPtr>& shots,
             const TrinocularRig& rig)
{
  if (shots.empty() || shots.size() > acmap::max_shots)
    acmap::refuseArgument(
        "number of shots", static_cast<double>(shots.size()), "within [1, 256]");
  Shots lit;
  for (const TrinocularFrame::ConstPtr& shot : shots) {
    if (!shot)
      throw acmap::BadArgument("a shot is null");
    acmap::requireShotOf(rig, *shot);
    if (shot->pattern != TrinocularFrame::no_pattern)
      lit.push_back(shot.get());
  }
  if (lit.empty())
    lit.push_back(shots.front().get());
  return lit;
}

acmap::PairImages
imagesOf(const Shots& shots, RigCamera neighbour, double baseline)
{
  acmap::PairImages images;
  images.layout.transposed = neighbour == RigCamera::Vertical;
  images.layout.mirrored = baseline > 0.0;
  for (const TrinocularFrame* shot : shots) {
    images.reference.push_back(&shot->image(RigCamera::Reference));
    images.target.push_back(&shot->image(neighbour));
  }
  return images;
}

/** Returns the range of the same depths for a pair with another baseline. It is limited
 * to disparities within the image, which has \a side px along the baseline, but
 * contains at least one. */
acmap::DisparityRange
scaledRange(const acmap::DisparityRange& range, double ratio, int side)
{
  const double last = std::ceil((range.first + range.count - 1) * ratio);
  const double maximum = std::min<double>(last, side);
  const double first = std::min(std::floor(range.first * ratio), maximum);
  return {static_cast<int>(first), static_cast<int>(maximum - first) + 1};
}

} // namespace

/** The pairs of the rig, the horizontal one first. */
struct TrinocularMatching::Memory {
  struct Pair {
    RigCamera neighbour;
    double baseline; ///< metres, signed
    int side;        ///< size of the image along the baseline, px
    acmap::PairMatcher matcher;
    acmap::PairMatch match;
  };

  explicit Memory(const TrinocularRig& rig)
  {
    if (acmap::hasCamera(rig, RigCamera::Horizontal))
      pairs.push_back(
          {RigCamera::Horizontal, rig.baseline_horizontal, rig.width, {}, {}});
    if (acmap::hasCamera(rig, RigCamera::Vertical))
      pairs.push_back({RigCamera::Vertical, rig.baseline_vertical, rig.height, {}, {}});
  }

  std::vector<Pair> pairs;
};

TrinocularMatching::TrinocularMatching() = default;
TrinocularMatching::~TrinocularMatching() = default;

TrinocularMatching::TrinocularMatching(const TrinocularMatching& other)
{
  *this = other;
}

TrinocularMatching&
TrinocularMatching::operator=(const TrinocularMatching& other)
{
  rig_ = other.rig_;
  memory_.reset();
  x_offset_ = other.x_offset_;
  max_disparity_ = other.max_disparity_;
  ratio_filter_ = other.ratio_filter_;
  peak_filter_ = other.peak_filter_;
  correlation_threshold_ = other.correlation_threshold_;
  left_right_check_ = other.left_right_check_;
  left_right_threshold_ = other.left_right_threshold_;
  pair_agreement_ = other.pair_agreement_;
  require_agreement_ = other.require_agreement_;
  threads_ = other.threads_;
  progress_ = other.progress_;
  return *this;
}

void
TrinocularMatching::setInputRig(const TrinocularRig& rig)
{
  acmap::requireStereoRig(rig);
  rig_ = rig;
  memory_.reset();
}

const TrinocularRig&
TrinocularMatching::getInputRig() const
{
  if (!rig_)
    throw acmap::InitFailed("TrinocularMatching has no rig");
  return *rig_;
}

void
TrinocularMatching::setXOffset(int offset)
{
  acmap::requireInRange("minimum disparity", offset, 0, 4095, "px");
  x_offset_ = offset;
}

void
TrinocularMatching::setMaxDisparity(int disparities)
{
  acmap::requireInRange("number of disparities", disparities, 8, 1024, "px");
  max_disparity_ = disparities;
}

void
TrinocularMatching::setRatioFilter(int percent)
{
  acmap::requireInRange("ratio filter", percent, 0, 100, "percent");
  ratio_filter_ = percent;
}

void
TrinocularMatching::setPeakFilter(double deviation)
{
  acmap::requireInRange("peak filter", deviation, 0, 128, "grey levels");
  peak_filter_ = deviation;
}

void
TrinocularMatching::setCorrelationThreshold(double correlation)
{
  acmap::requireInRange("correlation threshold", correlation, -1, 1, "(no unit)");
  correlation_threshold_ = correlation;
}

void
TrinocularMatching::setLeftRightCheckThreshold(int threshold)
{
  acmap::requireInRange("left-right check threshold", threshold, 0, 16, "px");
  left_right_threshold_ = threshold;
}

void
TrinocularMatching::setPairAgreement(double difference)
{
  acmap::requireInRange("pair agreement", difference, 0.1, 16, "px");
  pair_agreement_ = difference;
}

void
TrinocularMatching::match(const TrinocularFrame& shot, MatchedDisparity& matched)
{
  // The shot outlives the call, so that a non-owning pointer is sufficient.
  match({TrinocularFrame::ConstPtr(TrinocularFrame::ConstPtr(), &shot)}, matched);
}

void
TrinocularMatching::match(const std::vector<TrinocularFrame::ConstPtr>& shots,
                          MatchedDisparity& matched)
{
  const Shots used = shotsToMatch(shots, getInputRig());
  TrinocularMatchingReport report;
  report.shots = used.size();
  if (used.size() < shots.size())
    report.remarks.push_back(std::to_string(shots.size() - used.size()) +
                             " shots without a pattern were left out");
  const acmap::Progress progress(progress_);
  acmap::StepTimer timer(report);
  progress.tell(0.0, "matching");
  matchPairs(used);
  timer.finish("pairs");
  progress.tell(0.9, "joining");
  MatchedDisparity joined;
  report.by_both_pairs = joinPairs(used.size(), joined);
  timer.finish("joining");
  report.outcomes = countOutcomes(joined);
  if (report.outcomes[0] == 0)
    report.remarks.push_back("no pixel was matched");
  progress.tell(1.0, "joining");
  matched = std::move(joined);
  report_ = std::move(report);
}

void
TrinocularMatching::matchPairs(const std::vector<const TrinocularFrame*>& shots)
{
  const acmap::MatchingRecipe recipe = acmap::recipeOf(
      shots.size(), shots.front()->pattern != TrinocularFrame::no_pattern);
  acmap::MatchTests tests;
  tests.uniqueness = ratio_filter_;
  tests.deviation = peak_filter_.value_or(recipe.min_deviation);
  tests.correlation = correlation_threshold_.value_or(recipe.min_correlation);
  tests.left_right = left_right_check_;
  tests.left_right_threshold = left_right_threshold_;
  if (!memory_)
    memory_ = std::make_unique<Memory>(*rig_);
  std::vector<Memory::Pair>& pairs = memory_->pairs;
  acmap::withThreads(threads_, [&] {
    oneapi::tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t i) {
      Memory::Pair& pair = pairs[i];
      const double ratio = std::abs(pair.baseline) / disparityBaseline(*rig_);
      pair.matcher.match(imagesOf(shots, pair.neighbour, pair.baseline),
                         recipe,
                         scaledRange({x_offset_, max_disparity_}, ratio, pair.side),
                         tests,
                         pair.match);
    });
  });
}

std::size_t
TrinocularMatching::joinPairs(std::size_t shots, MatchedDisparity& joined) const
{
  joined.disparity.width = rig_->width;
  joined.disparity.height = rig_->height;
  const auto support = static_cast<std::uint16_t>(shots);
  const std::vector<Memory::Pair>& pairs = memory_->pairs;
  if (pairs.size() == 1) {
    acmap::takePair(pairs[0].match, support, joined);
    return 0;
  }
  acmap::JoinSettings settings;
  settings.ratio = std::abs(pairs[0].baseline / pairs[1].baseline);
  settings.agreement = pair_agreement_;
  settings.require_agreement = require_agreement_;
  return acmap::joinPairs(pairs[0].match, pairs[1].match, settings, support, joined);
}

} // namespace pcl
