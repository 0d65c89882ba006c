#include "pattern_need.h"

#include <utility>

namespace pcl::acmap {

PatternNeed::PatternNeed(FrameRectifier rectifier)
: rectifier_(std::move(rectifier))
{
  // only counts the pixels that the patterns cover; nothing is matched
  fusion_.setMethod(DisparityFusion::Method::SpaceTime);
  fusion_.setInputRig(rectifier_.rig());
}

bool
PatternNeed::wantsMoreAfter(const TrinocularFrame& frame)
{
  if (observation_ != frame.observation)
    fusion_.clear();
  observation_ = frame.observation;
  const TrinocularFrame::Ptr shot(new TrinocularFrame(frame));
  rectifier_.rectify(*shot);
  fusion_.addShot(shot);
  return fusion_.wantsAnotherShot();
}

} // namespace pcl::acmap
