#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>

#include <string>

namespace pcl {

/** \brief What is wrong with a camera on a bus. \ingroup acquisition */
enum class CameraFault {
  None,
  NotFound,         ///< no such camera is on the bus
  PermissionDenied, ///< it is there, this user may not open it
  Busy,             ///< another program has it
  Unplugged,        ///< it was there, and is gone
  Silent,           ///< it gives no frame, or no answer, in time
  Corrupt,          ///< its frames come, none of them whole
  Malformed,        ///< its registers say what no camera can be
  Unsupported,      ///< it cannot do what was asked for
  Failed            ///< the bus or the system refuses; the message says what
};

/** \brief A word for messages and scripts, say `unplugged`. \ingroup acquisition */
ACMAP_EXPORT const char*
nameOf(CameraFault fault);

/** \brief A camera that cannot be opened, set or read; the message names camera and fault,
 * and what can be done where something can. \ingroup acquisition */
class ACMAP_EXPORT CameraException : public IOException {
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
