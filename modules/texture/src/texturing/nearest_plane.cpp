#include "texturing/canvas_painting.h"

#include <pcl/core/impl/parallel.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pcl::acmap::texturing {
namespace {

/** Bounding box of some points of a view in the map frame. */
Eigen::AlignedBox3d
boxOf(const ColoredView& view, std::size_t begin, std::size_t end)
{
  Eigen::AlignedBox3d box;
  for (std::size_t i = begin; i < end; ++i) {
    const Eigen::Vector3f point = view.points[i];
    if (point.allFinite())
      box.extend(view.T_map_camera * point.cast<double>());
  }
  return box;
}

/** The same of all its points. */
Eigen::AlignedBox3d
boxOf(const ColoredView& view)
{
  return parallelReduceChunks(
      view.points.size(),
      Eigen::AlignedBox3d(),
      [&](std::size_t begin, std::size_t end) { return boxOf(view, begin, end); },
      [](Eigen::AlignedBox3d& all, const Eigen::AlignedBox3d& next) {
        all.extend(next);
      });
}

/** A canvas to which points of a view can belong. */
struct NearCanvas {
  std::int32_t index;
  const Canvas* canvas;
  const Eigen::Vector4d* plane; ///< nullptr for a cylinder
  Eigen::AlignedBox3d box;

  /** \brief Can points in a box be so close to it? */
  bool
  isNear(const Eigen::AlignedBox3d& points, double maximum_distance) const
  {
    return points.exteriorDistance(box.center()) <
           box.diagonal().norm() / 2 + maximum_distance;
  }

  double
  distance(const Eigen::Vector3d& point) const
  {
    return plane ? std::abs(plane->head<3>().dot(point) + (*plane)[3])
                 : canvas->surface.distance(point);
  }
};

std::vector<NearCanvas>
canvasesNear(const ColoredView& view,
             const std::vector<Canvas>& canvases,
             double maximum_distance)
{
  std::vector<NearCanvas> near;
  const Eigen::AlignedBox3d seen = boxOf(view);
  if (seen.isEmpty())
    return near;
  const Eigen::Vector3d eye = view.T_map_camera.translation();
  for (std::size_t c = 0; c < canvases.size(); ++c) {
    const CanvasSurface& surface = canvases[c].surface;
    const NearCanvas one{
        static_cast<std::int32_t>(c), &canvases[c], surface.plane(), surface.box()};
    if ((!view.has_eye || surface.faces(eye)) && one.isNear(seen, maximum_distance))
      near.push_back(one);
  }
  return near;
}

/** Those near some points of the view: a cloud of a whole building has thousands, but
 * points that follow each other are mostly close to each other. */
std::vector<NearCanvas>
nearChunk(const ColoredView& view,
          std::size_t begin,
          std::size_t end,
          const std::vector<NearCanvas>& near,
          double maximum_distance)
{
  const Eigen::AlignedBox3d seen = boxOf(view, begin, end);
  std::vector<NearCanvas> chosen;
  if (!seen.isEmpty())
    std::copy_if(near.begin(),
                 near.end(),
                 std::back_inserter(chosen),
                 [&](const auto& one) { return one.isNear(seen, maximum_distance); });
  return chosen;
}

} // namespace

PointLabels
nearestCanvases(const ColoredView& view,
                const std::vector<Canvas>& canvases,
                double maximum_distance,
                TexelPlace outermost)
{
  const std::vector<NearCanvas> of_view =
      canvasesNear(view, canvases, maximum_distance);
  PointLabels nearest(view.points.size(), -1);
  parallelForChunks(nearest.size(), [&](std::size_t begin, std::size_t end) {
    const std::vector<NearCanvas> near =
        nearChunk(view, begin, end, of_view, maximum_distance);
    for (std::size_t i = begin; i < end; ++i) {
      if (!view.points[i].allFinite())
        continue;
      const Eigen::Vector3d point = view.T_map_camera * view.points[i].cast<double>();
      double minimum = maximum_distance;
      for (const NearCanvas& one : near) {
        const double distance = one.distance(point);
        if (distance < minimum &&
            one.canvas->at(one.canvas->surface.placeOf(point)) >= outermost) {
          minimum = distance;
          nearest[i] = one.index;
        }
      }
    }
  });
  return nearest;
}

} // namespace pcl::acmap::texturing
