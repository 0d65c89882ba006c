#include "session_shots.h"

#include <pcl/acquisition/trinocular_file_grabber.h>

namespace pcl::acmap {

SessionShots::SessionShots(const std::string& session, unsigned threads)
: session_(session)
, grabber_(std::make_unique<TrinocularFileGrabber>(session))
{
  const std::string rig = session + "/rig.yaml";
  rectifier_ = std::make_unique<FrameRectifier>(
      rig, grabber_->getRig(), hasBuiltCameras(rig), threads);
}

SessionShots::~SessionShots() = default;

const TrinocularRig&
SessionShots::rig() const
{
  return rectifier_->rig();
}

ObservationShots
SessionShots::of(std::size_t observation) const
{
  const auto number = static_cast<std::int32_t>(observation);
  // binary search: the frames are sorted by observation
  std::size_t first = 0, last = grabber_->frames();
  while (first < last) {
    const std::size_t middle = first + (last - first) / 2;
    if (grabber_->frame(middle)->observation < number)
      first = middle + 1;
    else
      last = middle;
  }
  ObservationShots shots;
  shots.number = observation;
  for (; first < grabber_->frames(); ++first) {
    const TrinocularFrame::Ptr frame = grabber_->frame(first);
    if (frame->observation != number)
      break;
    rectifier_->rectify(*frame);
    shots.frames.push_back(frame);
  }
  if (shots.frames.empty())
    throw InputFileException(session_ + ": has no shot of observation " +
                             std::to_string(observation));
  return shots;
}

const TrinocularFrame&
shotUnder(const ObservationShots& shots, std::int32_t pattern)
{
  for (const TrinocularFrame::ConstPtr& frame : shots.frames)
    if (frame->pattern == pattern)
      return *frame;
  throw InputFileException("observation " + std::to_string(shots.number) +
                           " has no shot " +
                           (pattern == TrinocularFrame::no_pattern
                                ? "with the projector off"
                                : "under pattern " + std::to_string(pattern)));
}

} // namespace pcl::acmap
