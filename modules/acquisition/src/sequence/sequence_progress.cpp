#include "sequence/sequence_progress.h"

namespace pcl::acmap {

SequenceProgress::SequenceProgress(std::size_t patterns)
: patterns_(static_cast<std::int32_t>(patterns))
{}

SequenceProgress::Shot
SequenceProgress::next()
{
  const std::lock_guard lock(mutex_);
  if (next_.pattern == patterns_)
    goToNextObservation();
  return next_;
}

/** Must be called with mutex_ locked. */
void
SequenceProgress::goToNextObservation()
{
  ++next_.observation;
  next_.pattern = TrinocularFrame::no_pattern;
}

void
SequenceProgress::give(const Shot& shot)
{
  const std::lock_guard lock(mutex_);
  ++report_.shots;
  if (next_.number != shot.number) // rewind was called while the shot was taken
    return;
  ++next_.number;
  ++next_.pattern;
}

/** Must be called with mutex_ locked. */
bool
SequenceProgress::follows(const Shot& shot) const
{
  return next_.number == shot.number + 1 && next_.observation == shot.observation;
}

bool
SequenceProgress::isUnderWay(const Shot& shot) const
{
  const std::lock_guard lock(mutex_);
  return follows(shot);
}

void
SequenceProgress::finish(const Shot& shot)
{
  const std::lock_guard lock(mutex_);
  if (!follows(shot))
    return;
  ++report_.observations;
  report_.spared += static_cast<std::size_t>(patterns_ - next_.pattern);
  goToNextObservation();
}

void
SequenceProgress::cutOff()
{
  const std::lock_guard lock(mutex_);
  if (next_.pattern == TrinocularFrame::no_pattern || next_.pattern == patterns_)
    return;
  report_.remarks.push_back("observation " + std::to_string(next_.observation) +
                            " was cut off after " + std::to_string(next_.pattern + 1) +
                            " of its " + std::to_string(patterns_ + 1) + " shots");
  goToNextObservation();
}

void
SequenceProgress::rewind()
{
  const std::lock_guard lock(mutex_);
  next_ = {};
}

void
SequenceProgress::beginStream()
{
  const std::lock_guard lock(mutex_);
  report_ = {};
}

PatternSequenceGrabberReport
SequenceProgress::report() const
{
  const std::lock_guard lock(mutex_);
  return report_;
}

} // namespace pcl::acmap
