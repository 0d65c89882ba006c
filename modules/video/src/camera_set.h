#pragma once

#include "grabbing_thread.h"

#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Images of all cameras, indexed by \ref RigCamera. */
struct ImageSet {
  std::array<CameraImage, 3> images;
  std::uint64_t stamp = 0; ///< microseconds, of the reference
};

/** \brief The opened cameras of a rig. */
class CameraSet {
public:
  enum class Outcome { Images, Broken, End, Stopped };

  struct Camera {
    std::string device;
    RigCamera place;
    bool is_recording;
    std::unique_ptr<GrabbingThread> thread;
  };

  /** \brief Opens the cameras and requests the size of the rig's images.
   * \param[in] devices in the order of the rig's cameras, as many
   * \param[in] pixel_format four characters, or empty
   * \throws as the opener */
  CameraSet(const TrinocularRig& rig,
            const std::vector<std::string>& devices,
            const VideoOpener& opener,
            const std::string& pixel_format);

  /** \brief Grabs the next image of each camera, all at the same time.
   * \param[in] timeout seconds
   * \param[in] stops ends the wait for cameras with Stopped when it is positive;
   * recordings do not block, and stay at the same image
   * \return End if all cameras are recordings, and one of them has ended
   * \throws CameraException Silent after the timeout, Unplugged if a camera gives no
   * image */
  Outcome
  grab(double timeout, const std::atomic<int>& stops);

  /** \brief Converts the images that were grabbed.
   * \return Images, or Broken if one of them is incomplete
   * \throws CameraException Unsupported if they do not have the size of the rig */
  Outcome
  retrieve(ImageSet& images);

  /** \brief Was the last grab stopped, so that cameras may still be in use? */
  bool
  isGrabbing() const
  {
    return is_grabbing_;
  }

  const std::vector<Camera>&
  cameras() const
  {
    return cameras_;
  }

private:
  int width_;
  int height_;
  std::vector<Camera> cameras_;
  bool are_recordings_ = true;
  bool is_grabbing_ = false;
};

/** \brief Refuses two cameras that give the same image, if it shows anything.
 * \throws BadArgumentException */
void
requireDifferentImages(const CameraSet& set, const ImageSet& images);

} // namespace pcl::acmap
