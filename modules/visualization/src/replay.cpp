#include "replay.h"

#include "pose_marker.h"

#include <pcl/exceptions.h>

#include <algorithm>

namespace pcl::acmap {

void
Replay::start()
{
  if (!flight_) {
    Flight flight(stage_.trajectory());
    if (flight.isEmpty())
      throw BadArgumentException("there is no trajectory to fly along");
    flight_ = std::move(flight);
    time_ = 0;
  }
  if (time_ >= flight_->seconds())
    time_ = 0;
  if (!marker_) {
    marker_ = actorOfMarker();
    stage_.renderer()->AddActor(marker_);
  }
  running_ = true;
  advance(0);
}

void
Replay::stop()
{
  running_ = false;
}

void
Replay::leave()
{
  running_ = false;
  flight_.reset();
  if (marker_)
    stage_.renderer()->RemoveActor(marker_);
  marker_ = nullptr;
}

void
Replay::advance(double seconds)
{
  if (!running_)
    return;
  time_ = std::min(time_ + seconds, flight_->seconds());
  place(marker_, flight_->poseAt(time_));
  stage_.look(flight_->eyeAt(time_));
  // for a trajectory without length the first frame is the last one
  running_ = time_ < flight_->seconds();
}

std::string
Replay::describe() const
{
  if (!flight_)
    return {};
  return "pose " + std::to_string(flight_->rowAt(time_)) + " of 0 to " +
         std::to_string(stage_.trajectory().poses.size() - 1);
}

} // namespace pcl::acmap
