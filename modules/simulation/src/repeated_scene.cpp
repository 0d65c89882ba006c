#include <pcl/core/exceptions.h>
#include <pcl/simulation/repeated_scene.h>

#include <string>

namespace pcl {

namespace {

/** A box around a surface; around cylinders and discs it may be too large. */
Eigen::AlignedBox3d
boxOf(const SimulatedSurface& surface)
{
  Eigen::AlignedBox3d box;
  const auto addBall = [&box](const Eigen::Vector3d& center, double radius) {
    box.extend(center + Eigen::Vector3d::Constant(radius));
    box.extend(center - Eigen::Vector3d::Constant(radius));
  };
  if (const auto* const rectangle = std::get_if<SimulatedRectangle>(&surface.shape)) {
    const Eigen::Vector3d far =
        rectangle->corner + rectangle->edge_u + rectangle->edge_v;
    for (const Eigen::Vector3d& corner : {rectangle->corner,
                                          Eigen::Vector3d(far - rectangle->edge_u),
                                          Eigen::Vector3d(far - rectangle->edge_v),
                                          far})
      box.extend(corner);
  }
  else if (const auto* const cylinder =
               std::get_if<SimulatedCylinder>(&surface.shape)) {
    addBall(cylinder->base, cylinder->radius);
    addBall(cylinder->base + cylinder->axis, cylinder->radius);
  }
  else {
    const auto& disc = std::get<SimulatedDisc>(surface.shape);
    addBall(disc.center, disc.radius);
  }
  return box;
}

} // namespace

SimulatedScene
repeatedScene(const SimulatedScene& scene, std::size_t columns, std::size_t rows)
{
  if (columns == 0 || rows == 0)
    throw acmap::BadArgument("a scene needs a column and a row");
  constexpr double gap = 2; // metres
  Eigen::AlignedBox3d box;
  for (const SimulatedSurface& surface : scene.geometry.surfaces())
    box.extend(boxOf(surface));
  const Eigen::Vector3d step = box.sizes() + Eigen::Vector3d::Constant(gap);
  SimulatedScene all = scene;
  for (std::size_t copy = 1; copy < columns * rows; ++copy) {
    const std::size_t column = copy % columns, row = copy / columns;
    const Eigen::Vector3d shift(
        static_cast<double>(column) * step.x(), 0, static_cast<double>(row) * step.z());
    all.geometry.addMoved(scene.geometry,
                          shift,
                          " (" + std::to_string(column) + ", " + std::to_string(row) +
                              ")");
    for (const Eigen::Isometry3d& view : scene.views)
      all.views.push_back(Eigen::Translation3d(shift) * view);
  }
  return all;
}

SimulatedObservation
observeRepeated(const SimulatedScene& scene, std::size_t view, std::uint64_t seed)
{
  if (scene.views.empty())
    throw acmap::BadArgument("a scene without views");
  const std::size_t copy = view / scene.views.size();
  SimulatedObservation observation =
      observe(scene, view % scene.views.size(), seed + copy);
  const auto first = static_cast<std::uint32_t>(copy * scene.geometry.planes().size());
  for (ObservationPixel& pixel : observation.pixels)
    if (pixel.label > 0)
      pixel.label += first;
  return observation;
}

} // namespace pcl
