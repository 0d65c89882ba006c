#include <pcl/core/exceptions.h>
#include <pcl/simulation/simulated_truth.h>

#include "light/lit_view.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/simulation/ray_casting.h>

#include <limits>

namespace pcl {

namespace {

using acmap::PinholeScene;

/** \brief A neighbour of the reference camera. */
class NeighbourCamera {
public:
  NeighbourCamera(const SimulatedScene& scene,
                  const Eigen::Isometry3d& T_scene_reference,
                  const Eigen::Vector3d& place)
  : rig_(scene.rig)
  , place_(place)
  , seen_(scene.geometry,
          scene.rig,
          T_scene_reference * Eigen::Isometry3d(Eigen::Translation3d(place)))
  {}

  float
  disparityAt(double depth) const
  {
    return static_cast<float>(rig_.focal_length * place_.norm() / depth);
  }

  /** \param[in] point in the frame of the reference */
  bool
  sees(const Eigen::Vector3d& point) const
  {
    const Eigen::Vector3d there = point - place_;
    const double column = rig_.focal_length * there.x() / there.z() + rig_.center_x;
    const double row = rig_.focal_length * there.y() / there.z() + rig_.center_y;
    constexpr double half = 0.5; // of a pixel
    return column >= -half && column <= rig_.width - half && row >= -half &&
           row <= rig_.height - half && seen_.sees(there);
  }

private:
  TrinocularRig rig_;
  Eigen::Vector3d place_;
  PinholeScene seen_;
};

DisparityImage
emptyImage(const TrinocularRig& rig)
{
  DisparityImage image;
  image.width = rig.width;
  image.height = rig.height;
  image.values.assign(static_cast<std::size_t>(rig.width) *
                          static_cast<std::size_t>(rig.height),
                      std::numeric_limits<float>::quiet_NaN());
  return image;
}

/** \brief Computes the disparities and visibility flags of one neighbour. */
void
fillNeighbour(const SimulatedScene& scene,
              const Eigen::Isometry3d& T_scene_reference,
              const Eigen::Vector3d& place,
              const SurfaceImage& image,
              std::uint8_t flag,
              DisparityImage& disparities,
              std::vector<std::uint8_t>& visible)
{
  if (place.isZero())
    return;
  disparities = emptyImage(scene.rig);
  const NeighbourCamera neighbour(scene, T_scene_reference, place);
  const auto width = static_cast<std::size_t>(image.width);
  acmap::parallelForChunks(visible.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (image.surface[i] < 0)
        continue;
      const Eigen::Vector3d point =
          image.distance[i] *
          pixelRay(scene.rig, static_cast<int>(i % width), static_cast<int>(i / width));
      disparities.values[i] = neighbour.disparityAt(point.z());
      if (neighbour.sees(point))
        visible[i] |= flag;
    }
  });
}

void
flagLight(const SimulatedScene& scene,
          const Eigen::Isometry3d& T_scene_reference,
          const SimulatedProjector& projector,
          std::vector<std::uint8_t>& visible)
{
  SimulatedLight light;
  light.projector = projector;
  light.projector.power = 1.0;
  const acmap::PlacedProjector placed(scene.geometry,
                                      light.projector,
                                      T_scene_reference *
                                          projector.T_reference_projector);
  const acmap::LitView view = acmap::castLitView(
      scene.geometry, acmap::raysOf(scene.rig)[0], T_scene_reference, placed, light);
  for (std::size_t i = 0; i < visible.size(); ++i)
    if (view.light[i] > 0.0f)
      visible[i] |= SimulatedTruth::in_light;
}

} // namespace

SimulatedTruth
truthOf(const SimulatedScene& scene,
        std::size_t view,
        const SimulatedProjector& projector)
{
  if (view >= scene.views.size())
    throw acmap::BadArgument("scene '" + scene.name + "' has no view " +
                             std::to_string(view));
  SimulatedLight light;
  light.projector = projector;
  requireSoundLight(light);
  const Eigen::Isometry3d& pose = scene.views[view];
  SurfaceImage image = castView(scene.geometry, scene.rig, pose);
  SimulatedTruth truth;
  truth.visible.assign(image.surface.size(), 0);
  fillNeighbour(scene,
                pose,
                {scene.rig.baseline_horizontal, 0, 0},
                image,
                SimulatedTruth::in_horizontal,
                truth.horizontal,
                truth.visible);
  fillNeighbour(scene,
                pose,
                {0, scene.rig.baseline_vertical, 0},
                image,
                SimulatedTruth::in_vertical,
                truth.vertical,
                truth.visible);
  flagLight(scene, pose, projector, truth.visible);
  truth.surfaces = std::move(image.surface);
  return truth;
}

} // namespace pcl
