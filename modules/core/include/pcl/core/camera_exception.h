#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>

#include <string>

namespace pcl {

/** \brief Faults of a camera. \ingroup core */
enum class CameraFault {
  None,
  NotFound,         ///< no such camera is on the bus
  PermissionDenied, ///< the camera is present, but this user may not open it
  Busy,             ///< another program uses it
  Unplugged,        ///< the camera was present and has been removed
  Silent,           ///< no frame or no answer arrived in time
  Corrupt,          ///< frames arrive, but none of them is complete
  Malformed,        ///< its registers contain invalid values
  Unsupported,      ///< the camera does not support what was requested
  Failed, ///< the bus or the operating system reports an error, see the message
  Moving  ///< cameras that are not synchronised did not see a scene that stands still
};

/** \brief Returns a name for messages and scripts, for example `unplugged`.
 * \ingroup core */
ACMAP_EXPORT const char*
nameOf(CameraFault fault);

/** \brief Thrown when a camera cannot be opened, configured or read. The message names
 * the camera, the fault and, where possible, a remedy. \ingroup core */
class ACMAP_EXPORT CameraException : public acmap::Plain<IOException> {
public:
  CameraException(CameraFault fault, const std::string& message);

  CameraFault
  fault() const
  {
    return fault_;
  }

private:
  CameraFault fault_;
};

} // namespace pcl
