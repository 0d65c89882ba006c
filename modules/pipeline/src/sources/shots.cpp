#include <pcl/core/exceptions.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/impl/yaml_node.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/core/rig_cameras.h>
#include <pcl/pipeline/session_source.h>
#include <pcl/stereo/matched_disparity.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {

namespace {

/** \brief Memory for the costs of all disparities of a rig's views, in bytes. */
std::size_t
disparityMemory(const TrinocularRig& rig, const acmap::SearchRange& range)
{
  constexpr double bytes = 4.0; // one disparity of a pair
  // the vertical pair has disparities in proportion to its baseline
  const double pairs =
      (std::abs(rig.baseline_horizontal) + std::abs(rig.baseline_vertical)) /
      disparityBaseline(rig);
  return static_cast<std::size_t>(bytes * pairs * rig.width * rig.height * range.count);
}

} // namespace

SessionSettings::SessionSettings()
{
  constexpr double nearest = 0.5, farthest = 10; // metres; nearer points take longer
  projection.setMinimumDepth(nearest);
  projection.setMaximumDepth(farthest);
}

namespace acmap {

FrameRectifier::FrameRectifier(const std::string& path,
                               const TrinocularRig& rig,
                               std::optional<RigCalibration> cameras,
                               unsigned threads)
: rig_(rig)
{
  if (disparityBaseline(rig_) == 0.0)
    throw InputFileException(path +
                             ": the reference has no neighbour, both baselines are 0");
  if (!cameras)
    return;
  rectification_.emplace();
  rectification_->setNumberOfThreads(threads);
  for (const RigCamera camera : {RigCamera::Horizontal, RigCamera::Vertical})
    cameras->camera(camera).is_there = hasCamera(rig_, camera);
  try {
    rectification_->setInputCalibration(*cameras);
  }
  catch (const BadArgumentException& fault) {
    throw InputFileException(path + ": " + fault.what());
  }
  const double sigma = rig_.disparity_sigma; // the rectification does not affect it
  rig_ = rectification_->getRig();
  rig_.disparity_sigma = sigma;
  for (const std::string& remark : rectification_->getReport().remarks)
    remarks_.push_back(path + ": " + remark);
}

void
FrameRectifier::rectify(TrinocularFrame& frame) const
{
  if (rectification_)
    rectification_->rectify(frame, frame);
}

bool
hasBuiltCameras(const std::string& path)
{
  return loadYaml(path).find("camera_reference") != nullptr;
}

std::optional<ObservationShots>
ShotGroups::add(const TrinocularFrame::ConstPtr& frame)
{
  const auto number = static_cast<std::size_t>(frame->observation);
  std::optional<ObservationShots> before;
  if (number != shots_.number)
    before = finish();
  const auto leave_out = [&](const std::string& reason) {
    if (cut_.insert(frame->observation).second)
      remarks_.push_back("observation " + std::to_string(frame->observation) +
                         ": its frames from " + std::to_string(frame->number) +
                         " on are left out, " + reason);
  };
  if (done_.count(number) > 0)
    leave_out("frames of another one stand before them");
  else if (shots_.frames.size() == max_shots)
    leave_out("there are " + std::to_string(max_shots) + " before them");
  else {
    shots_.number = number;
    shots_.frames.push_back(frame);
  }
  return before;
}

std::optional<ObservationShots>
ShotGroups::finish()
{
  ObservationShots shots = std::exchange(shots_, {});
  if (shots.frames.empty())
    return std::nullopt;
  done_.insert(shots.number);
  return shots;
}

void
ShotGroups::restart(std::set<std::size_t> done)
{
  shots_ = {};
  done_ = std::move(done);
}

double
depthOf(const TrinocularRig& rig, double disparity)
{
  return rig.focal_length * disparityBaseline(rig) / (disparity + disparityOffset(rig));
}

SearchRange
disparitiesBetween(const TrinocularRig& rig, double nearest, double farthest)
{
  // supported by TrinocularMatching
  constexpr int fewest_disparities = 8;
  constexpr int max_disparities = 1024;
  const double longest =
      (hasCamera(rig, RigCamera::Horizontal) ? rig.width : rig.height) - 1.0;
  const auto disparityAt = [&](double depth) {
    return rig.focal_length * disparityBaseline(rig) / depth - disparityOffset(rig);
  };
  const double from = std::floor(disparityAt(farthest)) - 1.0;
  if (from > longest)
    throw acmap::BadArgument("at " + acmap::shortNumber(farthest) +
                             " m disparities are longer than the image, " +
                             std::to_string(static_cast<long>(longest)) +
                             " px; the rig's baseline is " +
                             acmap::shortNumber(disparityBaseline(rig)) + " m");
  const double to = std::min(std::ceil(disparityAt(nearest)) + 1.0, longest);
  SearchRange range;
  range.minimum = static_cast<int>(std::max(from, 0.0));
  range.count = std::clamp(
      static_cast<int>(to) - range.minimum + 1, fewest_disparities, max_disparities);
  return range;
}

SearchRange
setUpStereo(const TrinocularRig& rig,
            const SessionSettings& settings,
            const CostCallback& cost,
            DisparityFusion& fusion,
            DisparityBackProjection& projection)
{
  const double nearest = settings.projection.getMinimumDepth();
  const double farthest = settings.projection.getMaximumDepth();
  if (nearest >= farthest)
    throw acmap::BadArgument("the minimum depth " + acmap::shortNumber(nearest) +
                             " m is not below the maximum depth " +
                             acmap::shortNumber(farthest) + " m");
  const SearchRange range = disparitiesBetween(rig, nearest, farthest);
  if (cost)
    cost(std::to_string(range.count) + " disparities of " + sizeText(rig) + " pixels",
         disparityMemory(rig, range),
         0);
  TrinocularMatching matching = settings.matching;
  matching.setXOffset(range.minimum);
  matching.setMaxDisparity(range.count);
  fusion.setMatching(matching);
  fusion.setInputRig(rig);
  fusion.setMethod(settings.method);
  fusion.setPassive(settings.isPassive());
  fusion.setNumberOfThreads(settings.threads);
  projection = settings.projection;
  projection.setInputRig(rig);
  projection.setNumberOfThreads(settings.threads);
  return range;
}

ShotFusion::ShotFusion(const TrinocularRig& rig,
                       const SessionSettings& settings,
                       const CostCallback& cost)
: range_(setUpStereo(rig, settings, cost, fusion_, projection_))
{}

SessionObservation
ShotFusion::fuse(const ObservationShots& shots, const ProgressCallback& progress)
{
  // most of the time is spent in the step that does the matching
  const bool at_once = fusion_.getMethod() == DisparityFusion::Method::SpaceTime;
  const double share_of_shots = at_once ? 0.05 : 0.95;
  const auto count = static_cast<double>(shots.frames.size());
  double begin = 0;
  double end = 0;
  if (progress)
    fusion_.setProgressCallback([&](double fraction, const std::string& step) {
      return progress(std::min(begin + fraction * (end - begin), end), step);
    });

  SessionObservation made;
  made.number = shots.number;
  made.frames = shots.frames.size();
  fusion_.clear();
  for (const TrinocularFrame::ConstPtr& frame : shots.frames) {
    end = share_of_shots * static_cast<double>(fusion_.shots() + 1) / count;
    fusion_.addShot(frame);
    begin = end;
  }
  end = 1;
  fusion_.fuse(made.matched);
  fusion_.setProgressCallback({}); // the callback refers to local variables
  made.fusion = fusion_.getReport();
  projection_.project(made.matched, fusion_.getColor(), made.cloud);
  made.projection = projection_.getReport();
  return made;
}

} // namespace acmap
} // namespace pcl
