#include "motion/odometry_run.h"

#include "motion/scan_matching.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/quantile.h>
#include <pcl/core/impl/size_text.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace pcl::acmap {

namespace {

using Egomotion = OdometryRun::Egomotion;
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

/** The motions to the first observations, all of which are probed. */
constexpr std::size_t all_probed = 5;

/** Is the motion to this observation probed with six degrees of freedom? The first ones
 * are, then ever fewer: the choice must not depend on how many observations follow. */
bool
isProbed(std::size_t index)
{
  constexpr std::size_t factor = 3;
  if (index <= all_probed)
    return true;
  while (index > 1 && index % factor == 0)
    index /= factor;
  return index == 1;
}

} // namespace

OdometryView
odometryView(std::size_t index, std::shared_ptr<const PointCloudFile> observation)
{
  OdometryView view;
  view.index = index;
  view.file = std::move(observation);
  const PCLPointCloud2& cloud = view.file->cloud;
  if (cloud.height > 1 && findColor(cloud))
    view.cloud = pointsWithColor(cloud);
  else
    view.surface = std::make_shared<ScanSurface>(view.file->points());
  return view;
}

OdometryView
odometryView(const ObservationSequence& sequence, std::size_t index)
{
  return odometryView(index, sequence.load(index).file);
}

void
PoseChain::add(OdometryView now)
{
  for (auto anchor = anchors_.rbegin(); anchor != anchors_.rend(); ++anchor)
    if (const auto T_before_now = estimate_(now, anchor->view)) {
      const Eigen::Isometry3d T_map_now = anchor->T_map_camera * *T_before_now;
      if (!has_begun_)
        beginWith(std::move(*anchor));
      keep_(now, T_map_now);
      hold({std::move(now), T_map_now});
      return;
    }
  if (!has_begun_)
    hold({std::move(now), Eigen::Isometry3d::Identity()});
}

void
PoseChain::beginWith(Anchor first)
{
  has_begun_ = true;
  keep_(first.view, first.T_map_camera);
  anchors_.clear();
  hold(std::move(first));
}

void
PoseChain::hold(Anchor anchor)
{
  constexpr std::size_t max_anchors = 3;
  anchors_.push_back(std::move(anchor));
  if (anchors_.size() > max_anchors)
    anchors_.pop_front();
}

OdometryRun::OdometryRun(const VisualOdometry& settings)
: of_step_(settings.getEgomotion())
, egomotion_(settings.getEgomotion())
, pair_callback_(settings.getPairCallback())
, pose_callback_(settings.getPoseCallback())
, chooses_model_(settings.getMeasureMotion() &&
                 egomotion_.getMotionModel() == MotionModel::Planar &&
                 !egomotion_.getPaperMode())
, chain_(newChain())
{
  result_.model = egomotion_.getMotionModel();
  egomotion_.setNumberOfThreads(settings.getNumberOfThreads());
}

PoseChain
OdometryRun::newChain()
{
  return {[this](const OdometryView& now, const OdometryView& before) {
            return estimate(now, before);
          },
          [this](const OdometryView& view, const Eigen::Isometry3d& T_map_camera) {
            keep(view, T_map_camera);
          }};
}

void
OdometryRun::setProgressCallback(ProgressCallback progress)
{
  egomotion_.setProgressCallback(std::move(progress));
}

void
OdometryRun::requireSameKind(const OdometryView& view, const std::string& name)
{
  if (view.surface && egomotion_.getPaperMode())
    throw InputFileException(name +
                             ": has no image, which the paper's egomotion needs: "
                             "an organized cloud with a field rgb");
  const std::string size =
      view.surface ? "no image" : sizeText(*view.cloud) + " points";
  if (size_.empty())
    size_ = size;
  if (size != size_)
    throw InputFileException(name + ": has " + size +
                             ", the observations before have " + size_);
}

void
OdometryRun::add(OdometryView view, const std::string& name)
{
  requireSameKind(view, name);
  if (view.surface) {
    result_.model = MotionModel::Rigid;
    chooses_model_ = false;
  }
  result_.poses.resize(view.index + 1);
  if (of_step_.getMotionModel() == MotionModel::Planar && view.cloud && last_.cloud &&
      isProbed(view.index))
    probeFreeMotion(view);
  last_ = view;
  last_.file = nullptr;
  if (chooses_model_)
    first_.push_back(view);
  chain_.add(std::move(view));
  if (first_.size() > all_probed)
    chooseModel();
}

void
OdometryRun::chooseModel()
{
  chooses_model_ = false;
  const std::vector<OdometryView> first = std::move(first_);
  first_.clear();
  if (!judgePath(result_.free).is_in_space)
    return;
  result_.model = MotionModel::Rigid;
  of_step_.setMotionModel(MotionModel::Rigid);
  egomotion_.setMotionModel(MotionModel::Rigid);
  result_.pairs.clear();
  result_.poses.assign(result_.poses.size(), std::nullopt);
  chain_ = newChain();
  for (const OdometryView& view : first)
    chain_.add(view);
}

const VisualOdometryResult&
OdometryRun::finish(std::size_t observations)
{
  if (chooses_model_)
    chooseModel();
  result_.poses.resize(observations);
  const auto is_beyond = [&](const OdometryPair& pair) {
    return pair.now >= observations;
  };
  result_.pairs.erase(
      std::remove_if(result_.pairs.begin(), result_.pairs.end(), is_beyond),
      result_.pairs.end());
  result_.free.tilt = medianOf(tilts_);
  result_.free.rise = medianOf(rises_);
  return result_;
}

/** Estimates the motion to the next observation with six degrees of freedom. */
void
OdometryRun::probeFreeMotion(const OdometryView& now)
{
  setReach(1, of_step_, egomotion_);
  Egomotion egomotion = egomotion_;
  egomotion.setMotionModel(MotionModel::Rigid);
  egomotion.setInputTarget(last_.cloud);
  egomotion.setInputSource(now.cloud);
  const std::optional<EgomotionEstimate> estimate = egomotion.compute();
  if (!estimate)
    return;
  const Eigen::Isometry3d& motion = estimate->T_target_source;
  tilts_.push_back(std::acos(std::clamp(motion.linear()(1, 1), -1.0, 1.0)));
  rises_.push_back(std::abs(motion.translation().y()));
  ++result_.free.pairs;
  result_.free.free += isFree(*estimate, tilts_.back(), rises_.back());
}

std::optional<EgomotionEstimate>
OdometryRun::estimateOfSurfaces(const OdometryView& now,
                                const OdometryView& before,
                                EgomotionReport& report)
{
  constexpr double farther = 3;         // than a camera, whose views must overlap
  constexpr double max_translation = 5; // metres, times that; the starts are a lattice
  constexpr std::size_t max_steps = 2;
  const std::size_t steps = now.index - before.index;
  if (steps > max_steps) { // with little overlap, a place that looks alike fits better
    report.outcome = EgomotionOutcome::Inconsistent;
    report.reason = "scans that are more than two apart are not compared";
    return std::nullopt;
  }
  Eigen::Isometry3d guess = Eigen::Isometry3d::Identity();
  for (std::size_t step = 0; step < steps; ++step)
    guess = guess * last_step_;
  const std::optional<EgomotionEstimate> found = matchScans(
      *now.surface,
      *before.surface,
      guess,
      {farther * std::min(egomotion_.getMaximumTranslation(), max_translation),
       egomotion_.getMaximumRotation()},
      report);
  if (found && steps == 1)
    last_step_ = found->T_target_source;
  return found;
}

std::optional<Eigen::Isometry3d>
OdometryRun::estimate(const OdometryView& now, const OdometryView& before)
{
  setReach(static_cast<double>(now.index - before.index), of_step_, egomotion_);
  if (now.surface) {
    EgomotionReport report;
    const auto found = estimateOfSurfaces(now, before, report);
    result_.pairs.push_back({now.index, before.index, report, found});
    return found ? std::optional(found->T_target_source) : std::nullopt;
  }
  egomotion_.setInputSource(now.cloud);
  egomotion_.setInputTarget(before.cloud);
  const std::optional<EgomotionEstimate> found = egomotion_.compute();
  result_.pairs.push_back({now.index, before.index, egomotion_.getReport(), found});
  if (pair_callback_)
    pair_callback_(result_.pairs.back(), egomotion_);
  return found ? std::optional(found->T_target_source) : std::nullopt;
}

void
OdometryRun::keep(const OdometryView& view, const Eigen::Isometry3d& T_map_camera)
{
  result_.poses[view.index] = T_map_camera;
  if (pose_callback_)
    pose_callback_(view.index, *view.file, T_map_camera);
}

} // namespace pcl::acmap
