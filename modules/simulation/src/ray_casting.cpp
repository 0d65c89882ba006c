#include <pcl/simulation/ray_casting.h>

#include "cast_target.h"

#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/parallel.h>

#include <algorithm>

namespace pcl {

namespace {

using acmap::CastTarget;
using acmap::DepthRange;

/** \brief Ray with z = 1, so that a factor of it is a depth. */
Eigen::Vector3d
depthRay(const TrinocularRig& rig, int column, int row)
{
  return {(column - rig.center_x) / rig.focal_length,
          (row - rig.center_y) / rig.focal_length,
          1.0};
}

std::vector<CastTarget>
targetsOf(const SceneGeometry& scene,
          const TrinocularRig& rig,
          const Eigen::Isometry3d& T_camera_scene,
          const DepthRange& range)
{
  std::vector<CastTarget> targets;
  for (std::size_t i = 0; i < scene.surfaces().size(); ++i)
    if (auto target = acmap::targetOf(scene.surfaces()[i],
                                      static_cast<std::int32_t>(i),
                                      rig,
                                      T_camera_scene,
                                      range))
      targets.push_back(std::move(*target));
  return targets;
}

/** \brief Columns [begin, end) of an image row, which contains depths instead of
 * distances. */
struct RowPart {
  const TrinocularRig& rig;
  const DepthRange& range;
  int row;
  int begin;
  int end;
  double* depth;         // of column 0
  std::int32_t* surface; // of column 0

  void
  cast(const CastTarget& target) const
  {
    const acmap::PixelBox& box = target.box;
    if (row < box.first_row || row > box.last_row)
      return;
    const int first = std::max(begin, box.first_column);
    const int last = std::min(end - 1, box.last_column);
    std::visit(
        [&](const auto& shape) {
          for (int column = first; column <= last; ++column) {
            const double found = shape.depth(depthRay(rig, column, row), range);
            if (range.contains(found) && found < depth[column]) {
              depth[column] = found;
              surface[column] = target.surface;
            }
          }
        },
        target.shape);
  }

  void
  turnDepthsIntoDistances() const
  {
    for (int column = begin; column < end; ++column)
      depth[column] = surface[column] < 0
                          ? std::numeric_limits<double>::quiet_NaN()
                          : depth[column] * depthRay(rig, column, row).norm();
  }
};

} // namespace

Eigen::Vector3d
pixelRay(const TrinocularRig& rig, int column, int row)
{
  return depthRay(rig, column, row).normalized();
}

SurfaceImage
castView(const SceneGeometry& scene,
         const TrinocularRig& rig,
         const Eigen::Isometry3d& T_scene_camera,
         double reach)
{
  requireSoundRig(rig);
  if (!(reach > 0.0))
    acmap::refuseArgument("reach", reach, "above 0 m");
  DepthRange range;
  range.maximum = reach;
  const std::vector<CastTarget> targets =
      targetsOf(scene, rig, T_scene_camera.inverse(), range);

  SurfaceImage image;
  image.width = rig.width;
  image.height = rig.height;
  const auto width = static_cast<std::size_t>(rig.width);
  const std::size_t pixels = width * static_cast<std::size_t>(rig.height);
  image.distance.assign(pixels, std::numeric_limits<double>::infinity());
  image.surface.assign(pixels, -1);
  acmap::parallelForChunks(pixels, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin / width; row * width < end; ++row) {
      const std::size_t start = row * width;
      const RowPart part{rig,
                         range,
                         static_cast<int>(row),
                         static_cast<int>(std::max(begin, start) - start),
                         static_cast<int>(std::min(end, start + width) - start),
                         &image.distance[start],
                         &image.surface[start]};
      for (const CastTarget& target : targets)
        part.cast(target);
      part.turnDepthsIntoDistances();
    }
  });
  return image;
}

} // namespace pcl
