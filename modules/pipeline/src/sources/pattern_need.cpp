#include <pcl/pipeline/pattern_need.h>

#include <utility>

namespace pcl::acmap {

PatternNeed::PatternNeed(FrameRectifier rectifier)
: rectifier_(std::move(rectifier))
{
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

std::optional<ObservationShots>
shotsOf(const std::vector<TrinocularFrame::ConstPtr>& frames,
        const FrameRectifier& rectifier,
        ShotGroups& groups)
{
  for (const TrinocularFrame::ConstPtr& frame : frames)
    groups.add(frame);
  std::optional<ObservationShots> shots = groups.finish();
  if (shots && rectifier.isRectifying())
    for (TrinocularFrame::ConstPtr& frame : shots->frames) {
      const TrinocularFrame::Ptr rectified(new TrinocularFrame(*frame));
      rectifier.rectify(*rectified);
      frame = rectified;
    }
  return shots;
}

} // namespace pcl::acmap
