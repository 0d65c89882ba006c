#pragma once

#include <pcl/core/rig_calibration.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/stereo/trinocular_rectification.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief The shots of an observation, rectified. */
struct ObservationShots {
  std::size_t number = 0; ///< of the observation
  std::vector<TrinocularFrame::ConstPtr> frames;
};

/** \brief Assigns the frames of a stream to observations. Frames of an observation that
 * arrive after frames of another one are left out, and so are more frames than can be
 * fused. */
class ShotGroups {
public:
  /** \brief Adds a frame.
   * \return the observation before, if the frame belongs to another one */
  std::optional<ObservationShots>
  add(const TrinocularFrame::ConstPtr& frame);

  /** \brief Ends the current observation.
   * \return nothing if it has no shot */
  std::optional<ObservationShots>
  finish();

  /** \brief Warnings about the frames that were left out. */
  const std::vector<std::string>&
  remarks() const
  {
    return remarks_;
  }

private:
  ObservationShots shots_;     // of the current observation
  std::set<std::size_t> done_; // numbers of observations
  std::set<std::int32_t> cut_; // observations with frames that were left out
  std::vector<std::string> remarks_;
};

/** \brief Prepares frames for matching: rectifies them unless they are rectified
 * already. */
class FrameRectifier {
public:
  /** \param[in] path of the rig's file
   * \param[in] rig of the frames; cameras that it does not have are not used
   * \param[in] is_raw true for unrectified frames of the cameras in the file
   * \param[in] threads 0 = all
   * \throws InputFileException when the rig cannot be matched; for unrectified frames
   * also when the file's cameras are missing, malformed or cannot be rectified */
  FrameRectifier(const std::string& path,
                 const TrinocularRig& rig,
                 bool is_raw,
                 unsigned threads);

  /** \brief Rig of the rectified frames. */
  const TrinocularRig&
  rig() const
  {
    return rig_;
  }

  bool
  isRectifying() const
  {
    return rectification_.has_value();
  }

  /** \brief Thread-safe. */
  void
  rectify(TrinocularFrame& frame) const;

  /** \brief Warnings about the cameras. */
  const std::vector<std::string>&
  remarks() const
  {
    return remarks_;
  }

private:
  TrinocularRig rig_;
  std::optional<TrinocularRectification> rectification_;
  std::vector<std::string> remarks_;
};

/** \brief Does a rig's file have unrectified cameras? The frames of a session with such
 * a file, and those of a camera, are not rectified yet.
 * \throws InputFileException when it cannot be read */
bool
hasBuiltCameras(const std::string& path);

} // namespace pcl::acmap
