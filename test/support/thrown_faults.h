#pragma once

#include "messages.h"

#include <pcl/core/camera_exception.h>

namespace pcl::acmap::test {

/** \brief The camera fault that a function throws; None if it throws none.
 * \param[out] message of the fault */
template <typename Work>
CameraFault
faultOf(const Work& work, std::string* message = nullptr)
{
  try {
    work();
  }
  catch (const CameraException& exception) {
    if (message)
      *message = exception.what();
    return exception.fault();
  }
  return CameraFault::None;
}

/** \brief The camera fault that ended the last stream of a grabber; None if it ended
 * normally. */
template <typename GrabberT>
CameraFault
streamFaultOf(const GrabberT& grabber, std::string* message = nullptr)
{
  return faultOf([&] { rethrowError(grabber); }, message);
}

} // namespace pcl::acmap::test
