#include "pose_chain.h"

#include <pcl/core/impl/cloud_fields.h>
#include <pcl/pipeline/visual_odometry.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <future>
#include <utility>

namespace pcl {

namespace acmap {

namespace {

using Egomotion = VisualOdometry::Egomotion;
using View = PointCloud<PointXYZRGBSigma>;

constexpr double pi = 3.14159265358979323846;

/** The points with their colours; `sigma` is 0 where the file has none. */
View::ConstPtr
pointsWithColor(const PCLPointCloud2& from)
{
  const std::size_t place = findField(from, "x")->offset;
  const std::size_t color = findColor(from)->offset;
  const PCLPointField* const sigma = findField(from, "sigma", PCLPointField::FLOAT32);
  View::Ptr cloud(new View(from.width, from.height));
  cloud->is_dense = from.is_dense != 0;
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    PointXYZRGBSigma& point = (*cloud)[i];
    const std::uint8_t* const row = &from.data[i * from.point_step];
    std::memcpy(point.data, row + place, 3 * sizeof(float));
    std::memcpy(&point.rgba, row + color, sizeof point.rgba);
    if (sigma)
      std::memcpy(&point.sigma, row + sigma->offset, sizeof point.sigma);
  }
  return cloud;
}

OdometryView
loadView(const ObservationSequence& sequence, std::size_t index)
{
  OdometryView view;
  view.index = index;
  view.file = sequence.load(index).file;
  const PCLPointCloud2& cloud = view.file->cloud;
  if (cloud.height < 2)
    throw InputFileException(sequence.path(index) +
                             ": is not organized, it has one row of points only");
  if (!findColor(cloud))
    throw InputFileException(sequence.path(index) +
                             ": has no colour, a field rgb is needed");
  view.cloud = pointsWithColor(cloud);
  return view;
}

std::string
sizeText(const View& cloud)
{
  return std::to_string(cloud.width) + " x " + std::to_string(cloud.height) + " points";
}

/** Reads the next observation while the motion of the last one is estimated. */
class ViewReader {
public:
  explicit ViewReader(const ObservationSequence& sequence)
  : sequence_(sequence)
  {
    beginWith(0);
  }

  /** \throws InputFileException if the observation cannot be used */
  OdometryView
  next()
  {
    OdometryView view = coming_.get();
    if (view.index + 1 < sequence_.size())
      beginWith(view.index + 1);
    requireSize(*view.cloud, sequence_.path(view.index));
    return view;
  }

private:
  void
  beginWith(std::size_t index)
  {
    coming_ = std::async(std::launch::async,
                         [this, index] { return loadView(sequence_, index); });
  }

  void
  requireSize(const View& cloud, const std::string& path)
  {
    if (size_.empty())
      size_ = sizeText(cloud);
    if (sizeText(cloud) != size_)
      throw InputFileException(path + ": has " + sizeText(cloud) +
                               ", the observations before have " + size_);
  }

  const ObservationSequence& sequence_;
  std::string size_; ///< of the first observation
  std::future<OdometryView> coming_;
};

/** Sets the search limits for two observations that are this number of steps apart.
 * They grow with the gap, but not so far that every motion would be possible. */
void
setReach(double steps, const Egomotion& of_step, Egomotion& egomotion)
{
  constexpr double max_steps = 3;
  constexpr double max_translation = 1e6; // metres
  steps = std::min(steps, max_steps);
  egomotion.setMaximumTranslation(
      std::min(steps * of_step.getMaximumTranslation(), max_translation));
  egomotion.setMaximumRotation(std::min(steps * of_step.getMaximumRotation(), pi));
}

double
medianOf(std::vector<double> values)
{
  if (values.empty())
    return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** Does a motion leave the floor by clearly more than its uncertainty? */
bool
isFree(const EgomotionEstimate& estimate, double tilt, double rise)
{
  constexpr double min_tilt = 0.5 * pi / 180, min_rise = 0.02; // radians, metres
  constexpr double sigmas = 4;
  const auto& covariance = estimate.covariance;
  return tilt > std::max(min_tilt,
                         sigmas * std::sqrt(covariance(3, 3) + covariance(5, 5))) ||
         rise > std::max(min_rise, sigmas * std::sqrt(covariance(1, 1)));
}

/** Estimates motions of neighbouring observations, spread over the sequence, with six
 * degrees of freedom. */
FreeMotion
probeFreeMotion(const ObservationSequence& sequence, Egomotion egomotion)
{
  constexpr std::size_t max_pairs = 5;
  egomotion.setMotionModel(MotionModel::Rigid);
  FreeMotion result;
  std::vector<double> tilts, rises;
  const std::size_t steps = sequence.size() - 1; // from one observation to the next
  const std::size_t pairs = std::min(steps, max_pairs);
  for (std::size_t k = 0; k < pairs; ++k) {
    const std::size_t first = (2 * k + 1) * steps / (2 * pairs);
    egomotion.setInputTarget(loadView(sequence, first).cloud);
    egomotion.setInputSource(loadView(sequence, first + 1).cloud);
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

} // namespace
} // namespace acmap

std::string
OdometryPair::reason(const std::vector<std::string>& names) const
{
  for (const auto& [view, name] : {std::pair{std::string("the source"), names[now]},
                                   {"the target", names[before]}})
    if (report.reason.rfind(view, 0) == 0)
      return name + report.reason.substr(view.size());
  return report.reason;
}

std::size_t
VisualOdometryResult::posed() const
{
  return static_cast<std::size_t>(std::count_if(
      poses.begin(), poses.end(), [](const auto& pose) { return pose.has_value(); }));
}

std::string
VisualOdometryResult::reasonOf(std::size_t lost,
                               const std::vector<std::string>& names) const
{
  for (const OdometryPair& pair : pairs)
    if (!pair.estimate && (pair.now == lost || pair.before == lost))
      return "with " + names[pair.now == lost ? pair.before : pair.now] + ": " +
             pair.reason(names);
  return {};
}

OdometryNoise
VisualOdometryResult::noise() const
{
  const auto deviation = [&](int i) {
    std::vector<double> values;
    for (const OdometryPair& pair : pairs)
      if (pair.estimate)
        values.push_back(std::sqrt(pair.estimate->covariance(i, i)));
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return values.empty() ? 0.0 : *middle;
  };
  const double length = std::max(deviation(0), deviation(2));
  const double turn = deviation(4);
  if (!(length > 0) || !(turn > 0))
    return {};
  return {length, 0, turn, 0};
}

EstimatedPoses
VisualOdometryResult::estimated(const std::vector<double>& stamps) const
{
  EstimatedPoses estimated;
  for (std::size_t i = 0; i < poses.size(); ++i)
    if (poses[i]) {
      estimated.places.push_back(i);
      estimated.trajectory.stamps.push_back(stamps[i]);
      estimated.trajectory.poses.push_back(*poses[i]);
    }
  estimated.noise = noise();
  return estimated;
}

VisualOdometryResult
VisualOdometry::compute(const ObservationSequence& sequence)
{
  const acmap::Progress progress(progress_);
  Report report;
  acmap::StepTimer timer(report);
  VisualOdometryResult result;
  result.poses.resize(sequence.size());
  double done = 0;
  Egomotion egomotion = egomotion_;
  egomotion.setNumberOfThreads(threads_);
  egomotion.setProgressCallback([&](double, const std::string& step) {
    return !progress_ || progress_(done, step);
  });
  const auto estimate = [&](const acmap::OdometryView& now,
                            const acmap::OdometryView& before) {
    acmap::setReach(
        static_cast<double>(now.index - before.index), egomotion_, egomotion);
    egomotion.setInputSource(now.cloud);
    egomotion.setInputTarget(before.cloud);
    const std::optional<EgomotionEstimate> found = egomotion.compute();
    result.pairs.push_back({now.index, before.index, egomotion.getReport(), found});
    if (pair_callback_)
      pair_callback_(result.pairs.back(), egomotion);
    return found ? std::optional(found->T_target_source) : std::nullopt;
  };
  const auto keep = [&](const acmap::OdometryView& view,
                        const Eigen::Isometry3d& T_map_camera) {
    result.poses[view.index] = T_map_camera;
    if (pose_callback_)
      pose_callback_(view.index, *view.file, T_map_camera);
  };
  acmap::PoseChain chain(estimate, keep);
  acmap::ViewReader reader(sequence);
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    done = static_cast<double>(i) / static_cast<double>(sequence.size());
    progress.tell(done, "estimating");
    chain.add(reader.next());
  }
  timer.finish("estimate");
  if (egomotion_.getMotionModel() == MotionModel::Planar && sequence.size() > 1) {
    done = 1;
    acmap::setReach(1, egomotion_, egomotion);
    result.free = acmap::probeFreeMotion(sequence, egomotion);
    timer.finish("probe free motion");
  }
  report_ = std::move(report);
  return result;
}

} // namespace pcl
