#include "poses/view_agreement.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/pipeline/pose_convention_check.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

namespace pcl {

namespace {

using acmap::RangeView;
using Pair = std::pair<std::size_t, std::size_t>;
using Poses = std::vector<Eigen::Isometry3d>;

constexpr double raw_per_nat = 16;
constexpr std::size_t min_pairs = 5; // that differ

bool
areSame(const PoseReading& a, const PoseReading& b)
{
  return a.convention == b.convention && a.scale == b.scale;
}

/** What is stated first, then all conventions in its unit, in metres and in millimetres. */
std::vector<PoseReading>
readingsBeside(const PoseReading& stated)
{
  std::vector<PoseReading> readings = {stated};
  for (const double scale : {stated.scale, 1.0, 0.001})
    for (std::size_t i = 0; i < acmap::pose_convention_names.size(); ++i) {
      const PoseReading reading = {static_cast<PoseConvention>(i), scale};
      if (std::none_of(readings.begin(), readings.end(), [&](const PoseReading& other) {
            return areSame(reading, other);
          }))
        readings.push_back(reading);
    }
  return readings;
}

/** The smallest distance of two cameras in any convention, in the unit of the poses. */
double
distanceOf(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b)
{
  return std::min((a.translation() - b.translation()).norm(),
                  (a.inverse().translation() - b.inverse().translation()).norm());
}

double
angleOf(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b)
{
  const double cosine = ((a.linear().transpose() * b.linear()).trace() - 1) / 2;
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

/** May the poses be in millimetres: do many steps have metres? */
bool
haveLongSteps(const Poses& recorded, double scale)
{
  constexpr double long_step = 2; // metres
  std::size_t long_steps = 0;
  for (std::size_t i = 1; i < recorded.size(); ++i)
    long_steps += scale * distanceOf(recorded[i - 1], recorded[i]) > long_step ? 1 : 0;
  return 10 * long_steps > recorded.size();
}

/** The view after another one that tells most: it sees much of the same, but is moved and
 * turned. */
std::size_t
partnerOf(std::size_t first, const Poses& recorded, double scale)
{
  constexpr std::size_t max_gap = 64;
  constexpr double all_moved = 1.5, all_turned = 30 * M_PI / 180, // nothing in common
      moved = 0.15, turned = 6 * M_PI / 180; // hardly, metres and rad
  std::size_t best = first + 1;
  double min_cost = std::numeric_limits<double>::infinity();
  for (std::size_t i = best; i < std::min(recorded.size(), first + max_gap + 1); ++i) {
    const double d = scale * distanceOf(recorded[first], recorded[i]),
                 angle = angleOf(recorded[first], recorded[i]);
    const double cost = d / all_moved + angle / all_turned +
                        std::max(0.0, 1 - d / moved) / 2 +
                        std::max(0.0, 1 - angle / turned) / 2;
    if (cost < min_cost) {
      min_cost = cost;
      best = i;
    }
  }
  return best;
}

/** Pairs of views, spread over the recording. */
std::vector<Pair>
pairsOf(const Poses& recorded, double scale)
{
  constexpr std::size_t max_pairs = 60;
  constexpr double millimetre = 0.001;
  const bool may_be_small = haveLongSteps(recorded, scale);
  const std::size_t firsts = recorded.size() - 1;
  const std::size_t count = std::min(firsts, max_pairs);
  std::vector<Pair> pairs;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t first = k * firsts / count;
    const double probable = may_be_small && k % 2 == 1 ? millimetre * scale : scale;
    pairs.emplace_back(first, partnerOf(first, recorded, probable));
  }
  return pairs;
}

/** Are all points before the camera, as those of a depth image? */
bool
areAhead(const acmap::PointView& points)
{
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].z() <= 0) // also false for NaN
      return false;
  return true;
}

/** Views, read once while they are needed. */
class Views {
public:
  explicit Views(const ObservationSequence& sequence)
  : sequence_(sequence)
  {}

  /** \return null if it cannot be read */
  std::shared_ptr<const RangeView>
  at(std::size_t i)
  {
    const auto kept = views_.find(i);
    return kept != views_.end() ? kept->second
                                : views_.emplace(i, read(i)).first->second;
  }

  /** Forgets those before an observation. */
  void
  forgetBefore(std::size_t i)
  {
    views_.erase(views_.begin(), views_.lower_bound(i));
  }

private:
  std::shared_ptr<const RangeView>
  read(std::size_t i) const
  {
    try {
      const std::shared_ptr<const PointCloudFile> seen = sequence_.loadMeasured(i);
      const acmap::PointView points = acmap::requirePoints(CloudRows::of(seen->cloud));
      return std::make_shared<RangeView>(points,
                                         seen->cloud.height > 1 && areAhead(points));
    }
    catch (const InputFileException&) {
      return nullptr; // told when it is read for the map
    }
  }

  const ObservationSequence& sequence_;
  std::map<std::size_t, std::shared_ptr<const RangeView>> views_;
};

/** The identity for an observation that cannot be read, which is then left out. */
Eigen::Isometry3d
recordedPose(const ObservationSequence& sequence, std::size_t i)
{
  try {
    return sequence.recordedPose(i);
  }
  catch (const InputFileException&) {
    return Eigen::Isometry3d::Identity();
  }
}

/** Agreement of each pair under each reading, and last, with both clouds as they are. */
using Scores = std::vector<std::vector<double>>;

double
sumOf(const Scores& scores, std::size_t reading)
{
  double sum = 0;
  for (const std::vector<double>& pair : scores)
    sum += pair[reading];
  return sum;
}

struct Contest {
  double nats = 0; ///< in favour of the first reading
  std::size_t differing = 0, agreeing = 0;
  double sum_first = 0, sum_second = 0; ///< over those that differ
  bool is_same = true;                  ///< Do both always give the same?
};

Contest
compare(const Scores& scores, std::size_t a, std::size_t b)
{
  constexpr double max_raw = 200, differs = 10, same = 0.5;
  Contest contest;
  for (const std::vector<double>& pair : scores) {
    const double more = pair[a] - pair[b];
    contest.nats += std::clamp(more, -max_raw, max_raw) / raw_per_nat;
    if (std::abs(more) > differs) {
      ++contest.differing;
      contest.sum_first += pair[a];
      contest.sum_second += pair[b];
    }
    contest.agreeing += more > differs ? 1 : 0;
    contest.is_same = contest.is_same && std::abs(more) < same;
  }
  return contest;
}

Scores
scoresOf(const ObservationSequence& sequence,
         const Poses& recorded,
         const std::vector<PoseReading>& readings,
         unsigned threads,
         const ProgressCallback& callback)
{
  const acmap::Progress progress(callback);
  const Eigen::Isometry3d& T_recorded_cloud = sequence.frameInRecorded();
  const std::vector<Pair> pairs = pairsOf(recorded, readings.front().scale);
  Scores scores;
  Views views(sequence);
  for (const auto& [first, second] : pairs) {
    progress.tell(static_cast<double>(first) / static_cast<double>(recorded.size()),
                  "checking poses");
    views.forgetBefore(first);
    const auto a = views.at(first), b = views.at(second);
    if (!a || !b)
      continue;
    const Eigen::Isometry3d &from = recorded[first], &to = recorded[second];
    std::vector<double> scored(readings.size() + 1);
    acmap::withThreads(threads, [&] {
      oneapi::tbb::parallel_for(std::size_t{0}, scored.size(), [&](std::size_t i) {
        const Eigen::Isometry3d T_a_b =
            i == readings.size()
                ? Eigen::Isometry3d::Identity()
                : (readPose(from, readings[i]) * T_recorded_cloud).inverse() *
                      readPose(to, readings[i]) * T_recorded_cloud;
        scored[i] = acmap::agreementOf(*a, *b, T_a_b);
      });
    });
    scores.push_back(std::move(scored));
  }
  return scores;
}

/** Is what is stated wrong? In a corridor, where no view tells how far the camera went, poses
 * with small errors are worse than none: what is wrong is much worse. */
bool
isWrong(const Contest& of_best)
{
  constexpr double wrong = 16; // nats
  constexpr double min_share = 0.8, much_worse = 0.5;
  return of_best.nats > wrong && of_best.differing >= min_pairs &&
         static_cast<double>(of_best.agreeing) >=
             min_share * static_cast<double>(of_best.differing) &&
         of_best.sum_second < much_worse * of_best.sum_first;
}

/** Judges the first reading, which is stated. */
void
judge(const Scores& scores,
      const std::vector<PoseReading>& readings,
      PoseConventionReport& report)
{
  constexpr double named = 8; // nats
  report.pairs = scores.size();
  std::size_t best = 0;
  for (std::size_t i = 1; i < readings.size(); ++i)
    if (sumOf(scores, i) > sumOf(scores, best))
      best = i;
  Contest contest = compare(scores, best, 0);
  const bool is_wrong = isWrong(contest);
  const std::size_t found = is_wrong ? best : 0;
  std::optional<Contest> closest;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const Contest other = compare(scores, found, i);
    if (i == found || (!is_wrong && other.is_same))
      continue;
    if (other.nats < named)
      report.equivalents.push_back(readings[i]);
    if (!closest || other.nats < closest->nats)
      closest = other;
  }
  if (!is_wrong)
    contest = closest.value_or(Contest());
  report.found = readings[found];
  report.margin = contest.nats;
  report.differing = contest.differing;
  report.agreeing = contest.agreeing;
  report.verdict = is_wrong ? PoseVerdict::Contradicted
                   : report.equivalents.empty() && contest.differing >= min_pairs
                       ? PoseVerdict::Agreeing
                       : PoseVerdict::Undetermined;
}

/** \brief Are the clouds in one frame, so that poses would move them once more? Views in the frames
 * of their cameras hardly lie on each other as they are, and better than by what is stated.
 * Without turns, poses in metres that are read in millimetres move nothing, either.
 * \param[in] may_be_small can the poses be in millimetres?
 * \return what shows it; empty: they are not */
std::string
inOneFrame(const Scores& scores,
           const std::vector<PoseReading>& readings,
           bool may_be_small)
{
  constexpr double alike = 8; // nats
  const Contest contest = compare(scores, readings.size(), 0);
  if (!isWrong(contest))
    return {};
  for (std::size_t i = 1; i < readings.size(); ++i)
    if (compare(scores, readings.size(), i).nats < (may_be_small ? alike : -alike))
      return {};
  return "its clouds fit on each other as they are (" +
         std::to_string(contest.agreeing) + " of " + std::to_string(contest.differing) +
         " pairs that differ): they are in one frame, and its poses would move them "
         "once "
         "more; merge them into one cloud";
}

/** \brief Poses that seem to be in another unit, because depths are: do they fit better if these
 * are wrong by five, as of the depth images of TUM and of others? */
void
blameDepths(const Scores& scores,
            const std::vector<PoseReading>& readings,
            PoseConventionReport& report)
{
  std::size_t best = 1;
  for (std::size_t i = 2; i < readings.size(); ++i)
    if (sumOf(scores, i) > sumOf(scores, best))
      best = i;
  const Contest contest = compare(scores, best, 0);
  if (best == 1 || !isWrong(contest))
    return;
  report.found = readings[best];
  report.equivalents.clear();
  report.margin = contest.nats;
  report.differing = contest.differing;
  report.agreeing = contest.agreeing;
}

/** What is stated, what was found, and what the stated poses are if the depths are wrong. */
std::vector<PoseReading>
readingsOfDepths(const PoseConventionReport& report)
{
  std::vector<PoseReading> readings = {report.stated, report.found};
  for (const double factor : {0.2, 5.0})
    for (std::size_t i = 0; i < acmap::pose_convention_names.size(); ++i)
      readings.push_back(
          {static_cast<PoseConvention>(i), factor * report.stated.scale});
  return readings;
}

std::string
optionsFor(const PoseReading& reading, double stated_scale)
{
  return "--pose-convention " +
         std::string(acmap::nameIn(acmap::pose_convention_names, reading.convention)) +
         (reading.scale == stated_scale
              ? ""
              : " --pose-scale " + acmap::shortNumber(reading.scale));
}

/** Hint at the depths where the unit of poses is that of nobody. */
std::string
depthsToBlame(const PoseConventionReport& report)
{
  const double factor = report.found.scale / report.stated.scale;
  if (factor != 0.2 && factor != 5)
    return {};
  return ", but more probably the depths are read " +
         acmap::shortNumber(std::max(factor, 1 / factor)) + " times too " +
         (factor < 1 ? "small" : "large") + ": --depth-scale states theirs";
}

std::string
contradictionOf(const PoseConventionReport& report, const std::string& source)
{
  std::string found = textOf(report.found);
  std::string options = optionsFor(report.found, report.stated.scale);
  for (const PoseReading& other : report.equivalents) {
    found += ", or " + textOf(other);
    options += ", or " + optionsFor(other, report.stated.scale);
  }
  const bool is_opengl = report.found.convention == PoseConvention::OpenGl ||
                         report.found.convention == PoseConvention::OpenGlWorldToCamera;
  return source + ": its poses are read as " + textOf(report.stated) +
         ", but neighbouring views fit as " + found + " (" +
         std::to_string(report.agreeing) + " of " + std::to_string(report.differing) +
         " pairs that differ, " + acmap::shortNumber(report.margin) + " nats)" +
         (is_opengl
              ? ", of the camera, or of camera and world, which views cannot tell "
                "apart"
              : "") +
         "; " + options + " states it" + depthsToBlame(report);
}

struct Finding {
  PoseConventionReport report;
  std::string in_one_frame; ///< what shows that the clouds are; empty: they are not
};

Finding
check(const ObservationSequence& posed,
      unsigned threads,
      const ProgressCallback& progress)
{
  Finding finding;
  PoseConventionReport& report = finding.report;
  report.stated = report.found = posed.poseReading();
  if (!posed.hasRecordedPoses() || posed.size() < 2)
    return finding;
  acmap::StepTimer timer(report);
  Poses recorded;
  for (std::size_t i = 0; i < posed.size(); ++i)
    recorded.push_back(recordedPose(posed, i));
  const std::vector<PoseReading> readings = readingsBeside(report.stated);
  const Scores scores = scoresOf(posed, recorded, readings, threads, progress);
  judge(scores, readings, report);
  finding.in_one_frame =
      inOneFrame(scores, readings, haveLongSteps(recorded, report.stated.scale));
  if (report.verdict == PoseVerdict::Contradicted &&
      report.found.scale != report.stated.scale) {
    const std::vector<PoseReading> others = readingsOfDepths(report);
    blameDepths(scoresOf(posed, recorded, others, threads, progress), others, report);
  }
  timer.finish("check");
  return finding;
}

} // namespace

std::string
textOf(const PoseConventionReport& report)
{
  constexpr double most = 0.99;
  std::string text = textOf(report.stated) + ", ";
  if (report.verdict != PoseVerdict::Agreeing)
    return text + "assumed: " + std::to_string(report.pairs) +
           " pairs of views do not tell";
  const double confidence = std::min(most, 1 / (1 + std::exp(-report.margin)));
  return text + acmap::shortNumber(confidence) + " (" +
         std::to_string(report.agreeing) + " of " + std::to_string(report.differing) +
         " pairs of views that differ)";
}

void
PoseConventionCheck::setScale(double scale)
{
  acmap::requireInRange("scale of the poses", scale, 1e-6, 1e6, "m");
  scale_ = scale;
}

ObservationSequence
PoseConventionCheck::read(const ObservationSequence& sequence) const
{
  const PoseReading& usual = sequence.poseReading();
  return sequence.withPosesRead(
      {convention_.value_or(usual.convention), scale_.value_or(usual.scale)});
}

ObservationSequence
PoseConventionCheck::assess(const ObservationSequence& sequence)
{
  ObservationSequence posed = read(sequence);
  report_ = check(posed, threads_, progress_).report;
  return posed;
}

ObservationSequence
PoseConventionCheck::compute(const ObservationSequence& sequence)
{
  ObservationSequence posed = read(sequence);
  Finding finding = check(posed, threads_, progress_);
  report_ = std::move(finding.report);
  if (!finding.in_one_frame.empty())
    throw InputFileException(sequence.source() + ": " + finding.in_one_frame);
  if (report_.verdict == PoseVerdict::Contradicted)
    throw InputFileException(contradictionOf(report_, sequence.source()));
  return posed;
}

} // namespace pcl
