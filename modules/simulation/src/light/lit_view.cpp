#include "lit_view.h"

#include "../surface_normal.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/simulation/surface_color.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

TrinocularRig
pinholeOf(const SimulatedProjector& projector)
{
  TrinocularRig pinhole;
  pinhole.width = projector.width;
  pinhole.height = projector.height;
  pinhole.focal_length = projector.focal_length;
  pinhole.center_x = projector.center_x;
  pinhole.center_y = projector.center_y;
  return pinhole;
}

/** \brief Casts the view of one camera at one pose. */
class ViewCaster {
public:
  ViewCaster(const SceneGeometry& scene,
             const CameraRays& rays,
             const Eigen::Isometry3d& T_scene_camera,
             const PlacedProjector& projector,
             const SimulatedLight& light)
  : scene_(scene)
  , rays_(rays)
  , T_scene_camera_(T_scene_camera)
  , projector_(projector)
  , light_(light)
  , seen_(scene, rays.pinhole, T_scene_camera)
  {}

  void
  castRow(int row, LitView& view) const
  {
    const auto start =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(rays_.width);
    for (int column = 0; column < rays_.width; ++column)
      castPixel(rays_.ray(column, row), start + static_cast<std::size_t>(column), view);
  }

private:
  void
  castPixel(const Eigen::Vector3d& ray, std::size_t pixel, LitView& view) const
  {
    const PinholeScene::Hit hit =
        std::isnan(ray.x() + ray.y()) ? PinholeScene::Hit{} : seen_.hit(ray);
    if (hit.surface < 0)
      return;
    const auto index = static_cast<std::size_t>(hit.surface);
    const SimulatedSurface& surface = scene_.surfaces()[index];
    const Eigen::Vector3d point = T_scene_camera_ * (hit.depth * ray);
    Eigen::Vector3d normal = surfaceNormal(surface, point);
    if (normal.dot(T_scene_camera_.linear() * ray) > 0.0)
      normal = -normal;
    const PlacedProjector::Light light = projector_.lightAt(point, normal);
    view.light[pixel] = light.strength;
    view.u[pixel] = light.u;
    view.v[pixel] = light.v;
    const auto color = surfaceColor(surface, index, point);
    const auto factor = static_cast<float>(light_.exposure * falloffAlong(ray));
    for (std::size_t channel = 0; channel < color.size(); ++channel)
      view.color[3 * pixel + channel] = factor * color[channel];
  }

  double
  falloffAlong(const Eigen::Vector3d& ray) const
  {
    const double squared = ray.squaredNorm(); // 1 / cosine^2
    return light_.vignetting ? 1.0 / (squared * squared) : 1.0;
  }

  const SceneGeometry& scene_;
  const CameraRays& rays_;
  const Eigen::Isometry3d& T_scene_camera_;
  const PlacedProjector& projector_;
  const SimulatedLight& light_;
  PinholeScene seen_;
};

} // namespace

PlacedProjector::PlacedProjector(const SceneGeometry& scene,
                                 const SimulatedProjector& projector,
                                 const Eigen::Isometry3d& T_scene_projector)
: projector_(projector)
, T_projector_scene_(T_scene_projector.inverse())
, seen_(scene, pinholeOf(projector), T_scene_projector)
{}

PlacedProjector::Light
PlacedProjector::lightAt(const Eigen::Vector3d& point,
                         const Eigen::Vector3d& normal) const
{
  constexpr double nearest = 1e-3; // metres
  const Eigen::Vector3d there = T_projector_scene_ * point;
  if (there.z() < nearest)
    return {};
  const double du = projector_.focal_length * there.x() / there.z();
  const double dv = projector_.focal_length * there.y() / there.z();
  const double u = projector_.center_x + du;
  const double v = projector_.center_y + dv;
  if (!(std::abs(u - 0.5 * (projector_.width - 1)) <= 0.5 * projector_.width &&
        std::abs(v - 0.5 * (projector_.height - 1)) <= 0.5 * projector_.height) ||
      std::hypot(du, dv) > projector_.aperture_radius)
    return {};
  const double squared = there.squaredNorm();
  const double cosine =
      -(T_projector_scene_.linear() * normal).dot(there) / std::sqrt(squared);
  if (cosine <= 0.0 || !seen_.sees(there))
    return {};
  const double falloff =
      projector_.falloff_distance * projector_.falloff_distance / squared;
  return {static_cast<float>(projector_.power * cosine * falloff),
          static_cast<float>(std::clamp(u, 0.0, projector_.width - 1.0)),
          static_cast<float>(std::clamp(v, 0.0, projector_.height - 1.0))};
}

LitView
castLitView(const SceneGeometry& scene,
            const CameraRays& rays,
            const Eigen::Isometry3d& T_scene_camera,
            const PlacedProjector& projector,
            const SimulatedLight& light)
{
  LitView view;
  view.width = rays.width;
  view.height = rays.height;
  const auto pixels =
      static_cast<std::size_t>(rays.width) * static_cast<std::size_t>(rays.height);
  if (pixels == 0)
    return view;
  view.color.resize(3 * pixels);
  view.light.resize(pixels);
  view.u.resize(pixels);
  view.v.resize(pixels);
  const ViewCaster caster(scene, rays, T_scene_camera, projector, light);
  oneapi::tbb::parallel_for(
      0, rays.height, [&](int row) { caster.castRow(row, view); });
  return view;
}

} // namespace pcl::acmap
