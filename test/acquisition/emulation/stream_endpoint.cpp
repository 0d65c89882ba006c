#include "stream_endpoint.h"

#include <algorithm>
#include <cerrno>
#include <utility>

namespace pcl::acmap::test {

bool
StreamEndpoint::hasFrame()
{
  // The rest of a frame is discarded when its stream ends.
  if (frame_ && frame_->stream != camera_.stream())
    frame_.reset();
  if (frame_)
    return true;
  frame_ = camera_.takeFrame();
  sent_ = 0;
  return frame_.has_value();
}

std::optional<StreamPart>
StreamEndpoint::next(std::size_t maximum)
{
  if (halted_)
    return StreamPart{{}, -EPIPE, false};
  if (std::exchange(empty_packet_, false))
    return StreamPart{};
  if (!hasFrame())
    return std::nullopt;
  return partOfFrame(maximum);
}

StreamPart
StreamEndpoint::partOfFrame(std::size_t maximum)
{
  StreamPart part;
  const FrameFault fault = frame_->fault;
  const bool breaks = fault == FrameFault::Stall || fault == FrameFault::Unplug ||
                      fault == FrameFault::Error;
  const std::size_t size = frame_->bytes.size();
  const std::size_t end = breaks ? size / 2 : size;
  const std::size_t count = std::min(maximum, end - sent_);
  if (count == size)
    part.bytes = std::move(frame_->bytes);
  else
    part.bytes.assign(frame_->bytes.data() + sent_,
                      frame_->bytes.data() + sent_ + count);
  sent_ += count;
  if (sent_ < end)
    return part;
  frame_.reset();
  halted_ = fault == FrameFault::Stall;
  empty_packet_ = fault == FrameFault::EmptyEnd;
  part.cable_cut = fault == FrameFault::Unplug;
  if (breaks)
    part.status = halted_ ? -EPIPE : part.cable_cut ? -ESHUTDOWN : -EPROTO;
  return part;
}

} // namespace pcl::acmap::test
