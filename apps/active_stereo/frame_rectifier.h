#pragma once

#include <pcl/core/rig_calibration.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/stereo/trinocular_rectification.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Makes frames ready for matching: what is rectified already stays as it is. */
class FrameRectifier {
public:
  /** \brief Of rectified frames.
   * \throws InputFileException when the rig cannot be matched
   * \param[in] path of its file, for messages */
  FrameRectifier(const std::string& path, const TrinocularRig& rig);

  /** \brief Of frames as the cameras of a file see them; those that the rig has not are
   * not used.
   * \param[in] threads 0 = all
   * \throws InputFileException likewise, and when the file's cameras are missing,
   * malformed or cannot be rectified */
  FrameRectifier(const std::string& path, const TrinocularRig& rig, unsigned threads);

  /** \brief Of the rectified frames. */
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

  /** \brief May be called from several threads at once. */
  void
  rectify(TrinocularFrame& frame) const;

  /** \brief What is odd about the cameras. */
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

/** \brief Whether a rig's file has the cameras as they are built: the frames of a session
 * with such a file, and those of a camera, are not rectified yet.
 * \throws InputFileException when it cannot be read */
bool
hasBuiltCameras(const std::string& path);

} // namespace pcl::acmap
