#include "shot_groups.h"

#include <pcl/stereo/matched_disparity.h>

namespace pcl::acmap {

bool
ShotGroups::add(const TrinocularFrame::ConstPtr& frame, ObservationShots& shots)
{
  const auto number = static_cast<std::size_t>(frame->observation);
  if (!shots.frames.empty() && number != shots.number)
    return false;
  if (done_.count(number) > 0)
    leaveOut(*frame, "frames of another one stand before them");
  else if (shots.frames.size() == max_shots)
    leaveOut(*frame, "there are " + std::to_string(max_shots) + " before them");
  else {
    shots.number = number;
    shots.frames.push_back(frame);
  }
  return true;
}

void
ShotGroups::leaveOut(const TrinocularFrame& frame, const std::string& reason)
{
  if (cut_.insert(frame.observation).second)
    remarks_.push_back("observation " + std::to_string(frame.observation) +
                       ": its frames from " + std::to_string(frame.number) +
                       " on are left out, " + reason);
}

} // namespace pcl::acmap
