#pragma once

#include "thrown_faults.h"

#include <pcl/core/trinocular_rig.h>
#include <pcl/video/camera_grabber.h>

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap::test {

constexpr int image_width = 64;
constexpr int image_height = 48;

/** \brief What a camera does; shared with the test. */
struct CameraScript {
  /** \brief Image number i, from 0, of all that were grabbed since it was opened. */
  std::function<CameraImage(int i)> image;

  std::atomic<int> images{1000000}; ///< number of images before grab fails
  std::atomic<bool> blocks{false};  ///< grab does not return
  std::atomic<int> opened{0};
  std::atomic<int> grabbed{0}; ///< since it was opened the last time
  std::atomic<bool> is_incomplete{false};
  bool is_recording = false;

  std::mutex mutex;
  std::map<VideoSetting, double> settings = {{VideoSetting::FramesPerSecond, 30},
                                             {VideoSetting::AutomaticExposure, 1},
                                             {VideoSetting::Exposure, 0.02}};
  /** \brief Settings that it has not, or cannot change. */
  std::vector<VideoSetting> refused;
  /** \brief Images that were grabbed when a setting was changed the last time. */
  std::map<VideoSetting, int> changed_at;
};

/** \brief Two or three cameras on the desk of a test: "left", "right", "top". */
class ScriptedCameras {
public:
  ScriptedCameras();

  /** \brief Lets grab return, so that threads end. */
  ~ScriptedCameras();

  CameraScript&
  camera(const std::string& device)
  {
    return *cameras_.at(device);
  }

  VideoOpener
  opener() const;

private:
  std::map<std::string, std::shared_ptr<CameraScript>> cameras_;
};

/** \brief A rig of the size of the images with a left neighbour, and none above. */
TrinocularRig
pairRig();

/** \brief An image with a texture of its own.
 * \param[in] seed of the texture
 * \param[in] shift of the scene, px */
CameraImage
texturedImage(int seed, int shift = 0);

/** \brief Collects the frames of a grabber. */
class TakenFrames {
public:
  explicit TakenFrames(TrinocularGrabber& grabber);

  std::vector<TrinocularFrame::ConstPtr>
  frames() const;

  std::size_t
  size() const
  {
    return frames().size();
  }

private:
  mutable std::mutex mutex_;
  std::vector<TrinocularFrame::ConstPtr> frames_;
};

/** \brief Takes a shot and waits for it. */
void
shoot(TrinocularGrabber& grabber);

} // namespace pcl::acmap::test
