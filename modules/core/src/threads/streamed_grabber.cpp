#include <pcl/core/streamed_grabber.h>

#include <utility>

namespace pcl::acmap {

StreamedGrabber::StreamedGrabber(std::string name)
: name_(std::move(name))
{}

StreamedGrabber::~StreamedGrabber() noexcept = default;

void
StreamedGrabber::stop()
{
  stream().stop();
}

void
StreamedGrabber::wait()
{
  stream().wait();
}

bool
StreamedGrabber::isRunning() const
{
  return stream().isRunning();
}

std::exception_ptr
StreamedGrabber::getError() const
{
  return stream().error();
}

std::string
StreamedGrabber::getName() const
{
  return name_;
}

} // namespace pcl::acmap
