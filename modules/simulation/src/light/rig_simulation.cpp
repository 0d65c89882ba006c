#include "rig_simulation.h"

#include "../random_streams.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/size_text.h>

#include <string>
#include <utility>

namespace pcl::acmap {

namespace {

/** \brief Checks that the cameras match the scene's rig. */
void
requireCameras(const RigRays& cameras, const TrinocularRig& rig)
{
  const RigRays expected = raysOf(rig);
  for (std::size_t i = 0; i < cameras.size(); ++i)
    if (cameras[i].width != expected[i].width ||
        cameras[i].height != expected[i].height)
      throw acmap::BadArgument("a camera of " + sizeText(cameras[i]) +
                               " pixels is refused: the rig of the scene has one of " +
                               sizeText(expected[i]) + " pixels (0: none) there");
}

void
requirePattern(const RgbImage& pattern, const SimulatedProjector& projector)
{
  const std::size_t values = 3 * static_cast<std::size_t>(projector.width) *
                             static_cast<std::size_t>(projector.height);
  if (pattern.width != projector.width || pattern.height != projector.height ||
      pattern.values.size() != values)
    throw acmap::BadArgument("a pattern of " + sizeText(pattern) +
                             " pixels is refused: the projector has " +
                             sizeText(projector) + " pixels");
}

} // namespace

RigSimulation::RigSimulation(SimulatedScene scene,
                             const std::vector<RgbImage>& patterns,
                             const SimulatedLight& light,
                             RigRays cameras)
: scene_(std::move(scene))
, light_(light)
, cameras_(std::move(cameras))
{
  requireSoundLight(light_);
  requireCameras(cameras_, scene_.rig);
  patterns_.reserve(patterns.size());
  for (const RgbImage& pattern : patterns) {
    requirePattern(pattern, light_.projector);
    patterns_.emplace_back(pattern, light_.projector.blur);
  }
}

LitViews
RigSimulation::cast(std::size_t observation) const
{
  if (observation >= scene_.views.size())
    throw acmap::BadArgument("scene '" + scene_.name + "' has no view " +
                             std::to_string(observation));
  const Eigen::Isometry3d& T_scene_reference = scene_.views[observation];
  const PlacedProjector projector(scene_.geometry,
                                  light_.projector,
                                  T_scene_reference *
                                      light_.projector.T_reference_projector);
  LitViews views;
  for (std::size_t i = 0; i < views.size(); ++i)
    views[i] = castLitView(scene_.geometry,
                           cameras_[i],
                           T_scene_reference * cameras_[i].T_reference_camera,
                           projector,
                           light_);
  return views;
}

TrinocularFrame::Ptr
RigSimulation::shoot(const LitViews& views,
                     std::size_t observation,
                     std::size_t shot,
                     std::uint64_t seed) const
{
  constexpr std::uint64_t shots_per_second = 14;
  constexpr std::uint64_t second = 1000000; // microseconds
  const auto frame = pcl::make_shared<TrinocularFrame>();
  frame->number = observation * shotsOfObservation() + shot;
  frame->observation = static_cast<std::int32_t>(observation);
  frame->pattern = static_cast<std::int32_t>(shot) - 1;
  frame->stamp = frame->number * second / shots_per_second;
  const std::uint64_t stream = mixedBits(mixedBits(seed, observation), shot);
  for (std::size_t i = 0; i < views.size(); ++i)
    frame->images[i] = shadeShot(views[i],
                                 shot == 0 ? nullptr : &patterns_[shot - 1],
                                 light_,
                                 mixedBits(stream, i));
  return frame;
}

TrinocularFrame::Ptr
ShotSequence::next()
{
  if (observation_ == settings_.observations)
    return {};
  const TrinocularFrame::Ptr frame = withThreads(settings_.threads, [&] {
    if (shot_ == 0)
      views_ = simulation_.cast(observation_);
    return simulation_.shoot(views_, observation_, shot_, settings_.seed);
  });
  if (++shot_ == simulation_.shotsOfObservation()) {
    shot_ = 0;
    ++observation_;
  }
  return frame;
}

} // namespace pcl::acmap
