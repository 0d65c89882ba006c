#include <pcl/core/camera_exception.h>

#include <array>

namespace pcl {

const char*
nameOf(CameraFault fault)
{
  constexpr std::array<const char*, 11> names = {"none",
                                                 "not found",
                                                 "permission denied",
                                                 "busy",
                                                 "unplugged",
                                                 "silent",
                                                 "corrupt",
                                                 "malformed",
                                                 "unsupported",
                                                 "failed",
                                                 "moving"};
  return names.at(static_cast<std::size_t>(fault));
}

CameraException::CameraException(CameraFault fault, const std::string& message)
: Plain(message)
, fault_(fault)
{}

} // namespace pcl
