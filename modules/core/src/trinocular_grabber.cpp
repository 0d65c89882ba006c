#include <pcl/core/trinocular_grabber.h>

namespace pcl {

TrinocularGrabber::~TrinocularGrabber() noexcept = default;

} // namespace pcl
