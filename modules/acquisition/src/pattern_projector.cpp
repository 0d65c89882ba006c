#include <pcl/acquisition/pattern_projector.h>

namespace pcl {

PatternProjector::~PatternProjector() = default;

} // namespace pcl
