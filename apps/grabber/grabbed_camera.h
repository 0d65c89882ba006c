#pragma once

#include "terminal.h"
#include "tool.h"

#include <pcl/acquisition/pattern_projector.h>
#include <pcl/core/image_file.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/core/trinocular_grabber.h>

#include <functional>
#include <memory>
#include <vector>

namespace pcl::acmap {

/** \brief A kind of camera, as the tools use it that grab frames. */
class GrabbedCamera {
public:
  virtual ~GrabbedCamera() = default;

  /** \brief Gives the frames; one for each trigger. */
  virtual shared_ptr<TrinocularGrabber>
  grabber() const = 0;

  /** \brief Tells it the unrectified cameras of the rig, if the rig's file has them. */
  virtual void
  setCalibration(const RigCalibration& /*cameras*/)
  {}

  /** \brief Checks of the camera that need patterns; called once, before the first
   * observation. May throw as a shot. */
  virtual void
  check(PatternProjector& /*projector*/,
        const std::vector<RgbImage>& /*patterns*/,
        StatusLine& /*status*/,
        StageLog& /*log*/)
  {}

  /** \brief Maximum time of a shot, seconds. */
  virtual double
  shotTimeout() const = 0;

  /** \brief Sets rate, lost and broken frames. */
  virtual void
  count(GrabStatus& status) const = 0;

  /** \brief Writes its part of summary, warnings and report. */
  virtual void
  tell(StageLog& log) const = 0;
};

/** \brief Opens a camera for frames of a rig, with the settings of the user.
 * \throws CameraException when there is no such camera, it cannot be opened or does not support a setting
 * \throws UsageError, BadArgumentException for settings that no camera supports */
using GrabbedCameraOpener =
    std::function<std::unique_ptr<GrabbedCamera>(const TrinocularRig& rig)>;

} // namespace pcl::acmap
