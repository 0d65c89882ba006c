#pragma once

#include <pcl/core/rig_calibration.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/stereo/trinocular_rectification.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Prepares frames for matching: rectifies them unless they are rectified
 * already. */
class FrameRectifier {
public:
  /** \brief For frames that are rectified already.
   * \throws InputFileException when the rig cannot be matched
   * \param[in] path of its file, for messages */
  FrameRectifier(const std::string& path, const TrinocularRig& rig);

  /** \brief For unrectified frames of the cameras in a file; cameras that the rig does
   * not have are not used.
   * \param[in] threads 0 = all
   * \throws InputFileException likewise, and when the file's cameras are missing,
   * malformed or cannot be rectified */
  FrameRectifier(const std::string& path, const TrinocularRig& rig, unsigned threads);

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
