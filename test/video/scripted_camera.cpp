#include "scripted_camera.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace pcl::acmap::test {

namespace {

class ScriptedVideo : public VideoSource {
public:
  explicit ScriptedVideo(std::shared_ptr<CameraScript> script)
  : script_(std::move(script))
  {
    ++script_->opened;
    script_->grabbed = 0;
  }

  bool
  grab() override
  {
    while (script_->blocks)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (script_->grabbed >= script_->images)
      return false;
    ++script_->grabbed;
    return true;
  }

  bool
  retrieve(CameraImage& image) override
  {
    if (script_->is_incomplete)
      return false;
    image = script_->image(script_->grabbed - 1);
    return true;
  }

  std::uint64_t
  stamp() const override
  {
    return static_cast<std::uint64_t>(script_->grabbed) * 33333;
  }

  bool
  isRecording() const override
  {
    return script_->is_recording;
  }

  bool
  set(VideoSetting setting, double value) override
  {
    const std::lock_guard lock(script_->mutex);
    const auto& refused = script_->refused;
    if (std::count(refused.begin(), refused.end(), setting) > 0)
      return false;
    script_->settings[setting] = value;
    script_->changed_at[setting] = script_->grabbed;
    return true;
  }

  std::optional<double>
  get(VideoSetting setting) const override
  {
    const std::lock_guard lock(script_->mutex);
    const auto found = script_->settings.find(setting);
    return found == script_->settings.end() ? std::nullopt
                                            : std::optional(found->second);
  }

private:
  std::shared_ptr<CameraScript> script_;
};

} // namespace

ScriptedCameras::ScriptedCameras()
{
  int seed = 0;
  for (const char* const name : {"left", "right", "top"}) {
    auto script = std::make_shared<CameraScript>();
    script->image = [seed](int) { return texturedImage(seed); };
    cameras_[name] = std::move(script);
    ++seed;
  }
}

ScriptedCameras::~ScriptedCameras()
{
  for (const auto& [name, script] : cameras_)
    script->blocks = false;
}

VideoOpener
ScriptedCameras::opener() const
{
  return [cameras = cameras_](const std::string& device) {
    return std::make_unique<ScriptedVideo>(cameras.at(device));
  };
}

TrinocularRig
pairRig()
{
  TrinocularRig rig;
  rig.width = image_width;
  rig.height = image_height;
  rig.focal_length = 52;
  rig.center_x = 31.5;
  rig.center_y = 23.5;
  rig.baseline_vertical = 0;
  return rig;
}

CameraImage
texturedImage(int seed, int shift)
{
  CameraImage image{image_width, image_height, 3, {}};
  for (int y = 0; y < image_height; ++y)
    for (int x = 0; x < image_width; ++x)
      for (int c = 0; c < 3; ++c) {
        const int stripe = (x + shift + seed * 3) / 5 + y / 4 * (seed + 1);
        image.values.push_back(static_cast<std::uint8_t>(stripe * 57 % 200 + 20 * c));
      }
  return image;
}

TakenFrames::TakenFrames(TrinocularGrabber& grabber)
{
  const std::function<TrinocularGrabber::FrameCallback> take =
      [this](const TrinocularFrame::ConstPtr& frame) {
        const std::lock_guard lock(mutex_);
        frames_.push_back(frame);
      };
  grabber.registerCallback(take);
}

std::vector<TrinocularFrame::ConstPtr>
TakenFrames::frames() const
{
  const std::lock_guard lock(mutex_);
  return frames_;
}

void
shoot(TrinocularGrabber& grabber)
{
  grabber.trigger();
  grabber.wait();
}

} // namespace pcl::acmap::test
