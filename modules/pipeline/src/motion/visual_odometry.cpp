#include "motion/odometry_run.h"

#include <pcl/core/impl/length_remarks.h>
#include <pcl/core/impl/quantile.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <utility>

namespace pcl {

namespace acmap {

namespace {

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
    return view;
  }

private:
  void
  beginWith(std::size_t index)
  {
    coming_ = std::async(std::launch::async,
                         [this, index] { return odometryView(sequence_, index); });
  }

  const ObservationSequence& sequence_;
  std::future<OdometryView> coming_;
};

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

CameraPathReport
VisualOdometryResult::path() const
{
  CameraPathReport report = judgePath(free);
  const bool was_free = report.is_in_space;
  report.is_in_space = model == MotionModel::Rigid;
  if (report.is_in_space != was_free) // later motions are others than the first ones
    report.confidence = 1 - report.confidence;
  return report;
}

OdometryNoise
VisualOdometryResult::noise() const
{
  const auto deviation = [&](int i) {
    std::vector<double> values;
    for (const OdometryPair& pair : pairs)
      if (pair.estimate)
        values.push_back(std::sqrt(pair.estimate->covariance(i, i)));
    return acmap::medianOf(values);
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
  double done = 0;
  acmap::OdometryRun run(*this);
  run.setProgressCallback([&](double, const std::string& step) {
    return !progress_ || progress_(done, step);
  });
  acmap::ViewReader reader(sequence);
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    done = static_cast<double>(i) / static_cast<double>(sequence.size());
    progress.tell(done, "estimating");
    acmap::OdometryView view = reader.next();
    if (i == 0)
      acmap::addRemarks(report, acmap::lengthRemarks(view.file->points()));
    run.add(std::move(view), sequence.path(i));
  }
  timer.finish("estimate");
  report_ = std::move(report);
  return run.finish(sequence.size());
}

} // namespace pcl
