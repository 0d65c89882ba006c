#include "filmed_by_camera.h"

#include "frame_bytes.h"

#include <pcl/acquisition/trinocular_recorder.h>
#include <pcl/simulation/simulated_rig_grabber.h>

#include <algorithm>

namespace pcl::acmap::test {

namespace {

constexpr int dark = ProjectorWatch::dark;

/** \brief Converts to the image of a camera without colour. */
void
makeGrey(CameraImage& image)
{
  std::vector<std::uint8_t> grey;
  for (std::size_t i = 0; i < image.values.size(); i += 3)
    grey.push_back(static_cast<std::uint8_t>(
        (image.values[i] + image.values[i + 1] + image.values[i + 2]) / 3));
  image.values = grey;
  image.channels = 1;
}

} // namespace

FilmedByCamera::FilmedByCamera(const SimulatedScene& scene,
                               const std::vector<RgbImage>& lights)
: rig_(scene.rig)
, patterns_(static_cast<int>(lights.size()) - 1)
, observations_(static_cast<int>(scene.views.size()))
{
  SimulatedLight light;
  light.projector.power = 3;
  light.exposure = 0.7;
  light.projector.width = lights.front().width;
  light.projector.height = lights.front().height;
  light.projector.center_x = 0.5 * (light.projector.width - 1);
  light.projector.center_y = 0.5 * (light.projector.height - 1);
  light.projector.focal_length = 0.9 * light.projector.width;
  const SimulatedRigGrabber grabber(scene, lights, light);
  for (int i = 0; i < observations_; ++i)
    for (const TrinocularFrame::Ptr& shot :
         grabber.observe(static_cast<std::size_t>(i))) {
      for (CameraImage& image : shot->images)
        makeGrey(image);
      shots_[{i, shot->pattern}] = *shot;
    }
  fillBytes();
}

void
FilmedByCamera::fillBytes()
{
  for (const auto& [shot, frame] : shots_)
    bytes_[shot] = interleaved(frame, order_);
}

void
FilmedByCamera::setOrder(const std::array<RigCamera, 3>& order)
{
  order_ = order;
  fillBytes();
}

void
FilmedByCamera::watch(const ProjectorWatch& projector)
{
  projector_ = &projector;
  observation_ = 0;
  saw_last_ = false;
  hangs_ = false;
  lingers_ = false;
  before_.clear();
  mixed_ = 0;
}

std::vector<std::uint8_t>
FilmedByCamera::expose(const Exposure& exposure)
{
  std::set<int> lights = projector_->shownWithin(exposure.begin, exposure.end);
  if (lights.count(ProjectorWatch::something_else) > 0)
    return std::vector<std::uint8_t>(exposure.setting.image_bytes, 255);
  if (lights.count(dark) > 0 && std::exchange(saw_last_, false))
    observation_ = std::min(observation_ + 1, observations_ - 1);
  if (lights.count(patterns_ - 1) > 0)
    saw_last_ = true;
  if (lingers_) {
    const std::set<int> before = std::exchange(before_, lights);
    lights.insert(before.begin(), before.end());
  }
  if (lights.size() > 1)
    ++mixed_;
  std::vector<std::uint8_t> mixed(exposure.setting.image_bytes, 0);
  for (const int light : lights) {
    const int seen = hangs_ ? std::min(light, 1) : light;
    const std::vector<std::uint8_t>& bytes = bytes_.at({observation_, seen});
    for (std::size_t i = 0; i < std::min(mixed.size(), bytes.size()); ++i)
      mixed[i] = static_cast<std::uint8_t>(mixed[i] + bytes[i] / lights.size());
  }
  return mixed;
}

void
FilmedByCamera::record(const std::string& session) const
{
  TrinocularRecorder recorder(session, rig_);
  for (const auto& [shot, frame] : shots_) // in the order in which they are taken
    if (shot.second < patterns_) {
      TrinocularFrame recorded = frame;
      recorded.number = recorder.frames();
      recorder.record(recorded);
    }
  recorder.finish();
}

} // namespace pcl::acmap::test
