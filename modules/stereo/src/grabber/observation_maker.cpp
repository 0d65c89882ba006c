#include "grabber/observation_maker.h"

#include <pcl/core/exceptions.h>

#include <algorithm>
#include <utility>

namespace pcl::acmap {

namespace {

std::string
nameOf(std::int32_t observation)
{
  return "observation " + std::to_string(observation);
}

/** \brief Returns true if b comes after a in the same observation. */
template <typename A>
bool
follows(const TrinocularFrame& b, const A& a)
{
  return b.observation == a.observation && b.number > a.number;
}

} // namespace

ObservationMaker::ObservationMaker(const TrinocularRig& rig, Give give)
: give_(std::move(give))
{
  projection_.setInputRig(rig);
  fusion_.setInputRig(rig);
}

void
ObservationMaker::clearReport()
{
  const std::lock_guard lock(mutex_);
  report_ = {};
}

void
ObservationMaker::resume()
{
  is_after_break_ = true;
}

void
ObservationMaker::take(const TrinocularFrame::ConstPtr& frame)
{
  if (!frame)
    throw acmap::BadArgument("the frame grabber gave a frame that is none");
  {
    const std::lock_guard lock(mutex_);
    ++report_.frames;
  }
  const bool is_after_break = std::exchange(is_after_break_, false);
  if (isLeftOver(*frame)) {
    if (is_after_break)
      remark(nameOf(frame->observation) +
             " was cut off before: its frames are left out");
    return;
  }
  if (!shots_.empty() && follows(*frame, *shots_.back()))
    shots_.push_back(frame);
  else
    begin(frame, is_after_break);
  fill(shots_);
}

void
ObservationMaker::begin(const TrinocularFrame::ConstPtr& frame, bool is_after_break)
{
  const Shots shots = std::exchange(shots_, {frame});
  if (!shots.empty()) {
    const TrinocularFrame& last = *shots.back();
    if (is_after_break && frame->number <= last.number)
      remark(nameOf(last.observation) +
             " is dropped: its session was rewound before it was over");
    else
      give(shots);
  }
  fusion_.clear();
}

bool
ObservationMaker::isLeftOver(const TrinocularFrame& frame)
{
  if (!cut_)
    return false;
  if (!follows(frame, *cut_)) {
    cut_.reset();
    return false;
  }
  return true;
}

void
ObservationMaker::finish()
{
  const Shots shots = std::exchange(shots_, {});
  if (!shots.empty())
    give(shots);
  fusion_.clear();
}

void
ObservationMaker::cutOff(const std::string& by)
{
  const Shots shots = std::exchange(shots_, {});
  fusion_.clear();
  if (shots.empty())
    return;
  const TrinocularFrame& last = *shots.back();
  cut_ = {last.observation, last.number};
  remark(nameOf(last.observation) + " was cut off by " + by + ": its " +
         std::to_string(shots.size()) +
         " shots are dropped, and those that may follow are left out");
}

/** Adds the shots that are not in the fusion: the new one, or all of them if a change
 * of the settings discarded them. */
void
ObservationMaker::fill(const Shots& shots)
{
  for (std::size_t i = fusion_.shots(); i < shots.size(); ++i)
    fusion_.addShot(shots[i]);
}

void
ObservationMaker::give(const Shots& shots)
{
  fill(shots);
  const auto disparity = pcl::make_shared<MatchedDisparity>();
  fusion_.fuse(*disparity);
  const auto cloud = pcl::make_shared<PointCloud<PointXYZRGBSigma>>();
  projection_.project(*disparity, fusion_.getColor(), *cloud);
  const TrinocularFrame& first = *shots.front();
  cloud->header.stamp = first.stamp;
  cloud->header.seq = static_cast<std::uint32_t>(first.observation);
  cloud->header.frame_id = "reference_camera";
  const ActiveStereoObservation observation{
      first.observation, cloud, disparity, fusion_.getReport()};
  const DisparityBackProjectionReport points = projection_.getReport();
  {
    const std::lock_guard lock(mutex_);
    ++report_.observations;
    addSeconds(observation.fusion);
    addSeconds(points);
  }
  for (const std::vector<std::string>* remarks :
       {&observation.fusion.remarks, &points.remarks})
    for (const std::string& text : *remarks)
      remark(nameOf(first.observation) + ": " + text);
  give_(observation);
}

void
ObservationMaker::remark(const std::string& text)
{
  const std::lock_guard lock(mutex_);
  report_.remarks.push_back(text);
}

/** Adds the seconds of each step to its sum over all observations. Must be called with
 * mutex_ locked. */
void
ObservationMaker::addSeconds(const Report& report)
{
  for (const auto& step : report.seconds) {
    const auto found =
        std::find_if(report_.seconds.begin(),
                     report_.seconds.end(),
                     [&](const auto& known) { return known.first == step.first; });
    if (found == report_.seconds.end())
      report_.seconds.push_back(step);
    else
      found->second += step.second;
  }
}

ActiveStereoGrabberReport
ObservationMaker::report() const
{
  const std::lock_guard lock(mutex_);
  return report_;
}

} // namespace pcl::acmap
