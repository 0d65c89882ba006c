#include <pcl/acquisition/iidc_bus.h>

namespace pcl {

IidcBus::~IidcBus() = default;

} // namespace pcl
