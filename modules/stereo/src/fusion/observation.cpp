#include "observation.h"

#include "matching/shot_check.h"

#include <utility>

namespace pcl::acmap {

static_assert(max_shots <= ShotColor::max_images);
static_assert(max_shots <= ShotCoverage::max_shots);

Observation::Observation(const TrinocularRig& rig)
: dark_color_(rig.width, rig.height)
, lit_color_(rig.width, rig.height)
, coverage_(rig.width, rig.height)
{}

void
Observation::addDark(const TrinocularFrame::ConstPtr& shot)
{
  const CameraImage& reference = shot->image(RigCamera::Reference);
  dark_color_.add(reference);
  coverage_.setDark(reference);
  if (!first_dark)
    first_dark = shot;
}

void
Observation::addLit(const CameraImage& reference, double deviation)
{
  lit_color_.add(reference);
  coverage_.add(reference);
  shares_.push_back(coverage_.share(deviation));
}

void
Observation::addMatched(MatchedDisparity shot, const Report& report)
{
  shot.support = {};
  matched.push_back(std::move(shot));
  for (const auto& step : report.seconds)
    matching_seconds += step.second;
}

CameraImage
Observation::color() const
{
  return (darkShots() > 0 ? dark_color_ : lit_color_).mean();
}

} // namespace pcl::acmap
