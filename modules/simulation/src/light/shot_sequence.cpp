#include "shot_sequence.h"

#include <pcl/core/parallel.h>

namespace pcl::acmap {

TrinocularFrame::Ptr
ShotSequence::next()
{
  if (observation_ == settings_.observations)
    return {};
  const TrinocularFrame::Ptr frame = withThreads(settings_.threads, [&] {
    if (shot_ == 0)
      views_ = simulation_.cast(observation_);
    return simulation_.shoot(views_, observation_, shot_, settings_.seed);
  });
  if (++shot_ == simulation_.shotsOfObservation()) {
    shot_ = 0;
    ++observation_;
  }
  return frame;
}

} // namespace pcl::acmap
