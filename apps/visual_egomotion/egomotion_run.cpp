#include "egomotion_run.h"

#include "cloud_fields.h"
#include "length_check.h"
#include "match_picture.h"
#include "observation_folder.h"
#include "pose_chain.h"

#include <pcl/egomotion/visual_egomotion.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <utility>

namespace pcl::acmap {

namespace {

using Egomotion = VisualEgomotion<PointXYZRGBSigma>;

constexpr double pi = 3.14159265358979323846;

std::string
sizeText(const PointCloud<PointXYZRGBSigma>& cloud)
{
  return std::to_string(cloud.width) + " x " + std::to_string(cloud.height) + " points";
}

/** \brief Estimates pairs, and keeps what they told. */
class PairEstimator {
public:
  PairEstimator(const Tool& tool,
                const EgomotionOptions& options,
                const OutputFolder& folder,
                const ProgressCallback& progress,
                EgomotionRun& run)
  : options_(options)
  , folder_(folder)
  , run_(run)
  {
    egomotion_.setMotionModel(options.is_rigid ? MotionModel::Rigid
                                               : MotionModel::Planar);
    egomotion_.setMaximumKeypoints(options.keypoints);
    egomotion_.setRefinement(options.refines);
    egomotion_.setNumberOfThreads(tool.threads());
    egomotion_.setProgressCallback(progress);
  }

  std::optional<Eigen::Isometry3d>
  operator()(const EgomotionObservation& now, const EgomotionObservation& before)
  {
    setReach(static_cast<double>(now.index - before.index));
    egomotion_.setInputSource(now.cloud);
    egomotion_.setInputTarget(before.cloud);
    const std::optional<EgomotionEstimate> estimate = egomotion_.compute();
    // of one that is lost, the pair with the observation before is shown
    if (options_.pictures && (estimate || !isTried(now.index)))
      savePng(folder_.path(numberedName("matches", now.index, ".png")),
              matchPicture(*now.cloud,
                           *before.cloud,
                           egomotion_.getMatches(),
                           egomotion_.getInliers()));
    run_.pairs.push_back({now.index, before.index, egomotion_.getReport(), estimate});
    if (!estimate)
      return std::nullopt;
    return estimate->T_target_source;
  }

private:
  bool
  isTried(std::size_t observation) const
  {
    return !run_.pairs.empty() && run_.pairs.back().now == observation;
  }

  /** What is within reach grows with a gap, though not so far that anything would be.
   * \param[in] steps from one observation to the next that lie between both */
  void
  setReach(double steps)
  {
    constexpr double most_steps = 3;
    steps = std::min(steps, most_steps);
    constexpr double farthest = 1e6; // metres
    egomotion_.setMaximumTranslation(
        std::min(steps * options_.most_translation, farthest));
    egomotion_.setMaximumRotation(
        std::min(steps * options_.most_rotation * pi / 180, pi));
  }

  const EgomotionOptions& options_;
  const OutputFolder& folder_;
  EgomotionRun& run_;
  Egomotion egomotion_;
};

double
medianOf(std::vector<double> values)
{
  if (values.empty())
    return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** \brief Whether a motion leaves the floor, clearly beyond what it may err by. */
bool
isFree(const EgomotionEstimate& estimate, double tilt, double rise)
{
  constexpr double least_tilt = 0.5 * pi / 180, least_rise = 0.02; // radians, metres
  constexpr double sigmas = 4;
  const auto& covariance = estimate.covariance;
  return tilt > std::max(least_tilt,
                         sigmas * std::sqrt(covariance(3, 3) + covariance(5, 5))) ||
         rise > std::max(least_rise, sigmas * std::sqrt(covariance(1, 1)));
}

/** \brief Tries neighbouring observations all over the sequence with six degrees of
 * freedom. */
FreeMotion
probeFreeMotion(const Tool& tool,
                const EgomotionOptions& options,
                const ObservationList& list,
                const ProgressCallback& progress)
{
  constexpr std::size_t most_pairs = 5;
  Egomotion egomotion;
  egomotion.setMotionModel(MotionModel::Rigid);
  egomotion.setMaximumKeypoints(options.keypoints);
  egomotion.setRefinement(options.refines);
  egomotion.setNumberOfThreads(tool.threads());
  egomotion.setMaximumTranslation(options.most_translation);
  egomotion.setMaximumRotation(options.most_rotation * pi / 180);
  egomotion.setProgressCallback(progress);
  FreeMotion result;
  std::vector<double> tilts, rises;
  const std::size_t steps = list.size() - 1; // from one to the next
  const std::size_t pairs = std::min(steps, most_pairs);
  for (std::size_t k = 0; k < pairs; ++k) {
    const std::size_t first = (2 * k + 1) * steps / (2 * pairs);
    egomotion.setInputTarget(
        loadEgomotionObservation(list.paths[first], first, tool.scale()).cloud);
    egomotion.setInputSource(
        loadEgomotionObservation(list.paths[first + 1], first + 1, tool.scale()).cloud);
    const std::optional<EgomotionEstimate> estimate = egomotion.compute();
    if (!estimate)
      continue;
    const Eigen::Isometry3d& motion = estimate->T_target_source;
    tilts.push_back(std::acos(std::clamp(motion.linear()(1, 1), -1.0, 1.0)));
    rises.push_back(std::abs(motion.translation().y()));
    ++result.pairs;
    result.free += isFree(*estimate, tilts.back(), rises.back());
  }
  result.tilt = medianOf(tilts);
  result.rise = medianOf(rises);
  return result;
}

/** \brief Reads the next observation while the one before is worked on. */
class ObservationReader {
public:
  ObservationReader(const ObservationList& list, double scale)
  : list_(list)
  , scale_(scale)
  {
    beginWith(0);
  }

  /** \throws InputFileException when it cannot be used */
  EgomotionObservation
  next()
  {
    EgomotionObservation observation = coming_.get();
    if (observation.index + 1 < list_.size())
      beginWith(observation.index + 1);
    requireSize(*observation.cloud, list_.paths[observation.index]);
    return observation;
  }

private:
  void
  beginWith(std::size_t index)
  {
    coming_ = std::async(std::launch::async, [this, index] {
      return loadEgomotionObservation(list_.paths[index], index, scale_);
    });
  }

  void
  requireSize(const PointCloud<PointXYZRGBSigma>& cloud, const std::string& path)
  {
    if (size_.empty())
      size_ = sizeText(cloud);
    if (sizeText(cloud) != size_)
      throw InputFileException(path + ": has " + sizeText(cloud) +
                               ", the observations before have " + size_);
  }

  const ObservationList& list_;
  double scale_;
  std::string size_; ///< of the first
  std::future<EgomotionObservation> coming_;
};

} // namespace

std::string
EgomotionPair::reason(const std::vector<std::string>& names) const
{
  for (const auto& [view, name] : {std::pair{std::string("the source"), names[now]},
                                   {"the target", names[before]}})
    if (report.reason.rfind(view, 0) == 0)
      return name + report.reason.substr(view.size());
  return report.reason;
}

std::size_t
EgomotionRun::posed() const
{
  return static_cast<std::size_t>(std::count_if(
      poses.begin(), poses.end(), [](const auto& pose) { return pose.has_value(); }));
}

std::string
EgomotionRun::reasonOf(std::size_t lost, const ObservationList& list) const
{
  for (const EgomotionPair& pair : pairs)
    if (!pair.estimate && (pair.now == lost || pair.before == lost))
      return "with " + list.names[pair.now == lost ? pair.before : pair.now] + ": " +
             pair.reason(list.names);
  return {};
}

Trajectory
EgomotionRun::trajectory(const std::vector<double>& stamps) const
{
  Trajectory trajectory;
  for (std::size_t i = 0; i < poses.size(); ++i)
    if (poses[i]) {
      trajectory.stamps.push_back(stamps[i]);
      trajectory.poses.push_back(*poses[i]);
    }
  return trajectory;
}

EgomotionRun
runEgomotion(Tool& tool,
             const EgomotionOptions& options,
             const ObservationList& list,
             const OutputFolder& folder)
{
  EgomotionRun run;
  run.poses.resize(list.size());
  const auto keep = [&](const EgomotionObservation& observation,
                        const Eigen::Isometry3d& T_map_camera) {
    run.poses[observation.index] = T_map_camera;
    if (!options.writes_observations)
      return;
    PCLPointCloud2 cloud = observation.file.cloud;
    dropUnwritableFields(cloud);
    saveObservation(folder.path(list.outputs[observation.index]), cloud, T_map_camera);
  };
  tool.withProgress([&](const ProgressCallback& callback) {
    const Progress progress(callback);
    double done = 0;
    PairEstimator estimate(
        tool,
        options,
        folder,
        [&](double, const std::string& step) { return callback(done, step); },
        run);
    PoseChain chain(std::ref(estimate), keep);
    ObservationReader reader(list, tool.scale());
    for (std::size_t i = 0; i < list.size(); ++i) {
      done = static_cast<double>(i) / static_cast<double>(list.size());
      progress.tell(done, "estimating");
      EgomotionObservation observation = reader.next();
      if (i == 0)
        warnOfLengths(tool, observation.file);
      chain.add(std::move(observation));
    }
    if (!options.is_rigid && list.size() > 1)
      run.free =
          probeFreeMotion(tool, options, list, [&](double, const std::string& step) {
            return callback(1, step);
          });
  });
  return run;
}

} // namespace pcl::acmap
