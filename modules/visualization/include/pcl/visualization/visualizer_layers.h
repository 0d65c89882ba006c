#pragma once

#include <pcl/visualization/map_layers.h>

/** \file
 * The layers of map_layers.h for `pcl::visualization::PCLVisualizer`, or for any other
 * class with a `getRendererCollection ()`: they are added to its first renderer. These
 * are templates, so that programs that do not use PCLVisualizer need not link it. Also
 * include `<pcl/visualization/pcl_visualizer.h>` and `<vtkRendererCollection.h>`. */

namespace pcl {
namespace acmap {

template <typename Visualizer>
auto
firstRenderer(Visualizer& visualizer)
    -> decltype(*visualizer.getRendererCollection()->GetFirstRenderer())
{
  return *visualizer.getRendererCollection()->GetFirstRenderer();
}

} // namespace acmap

template <typename Visualizer>
auto
addPointLayer(Visualizer& visualizer, const PCLPointCloud2& cloud)
    -> decltype(addPointLayer(acmap::firstRenderer(visualizer), cloud))
{
  return addPointLayer(acmap::firstRenderer(visualizer), cloud);
}

template <typename Visualizer>
auto
addMeshLayer(Visualizer& visualizer,
             const PCLPointCloud2& vertices,
             const TriangleMesh& mesh,
             bool hide_backs = false)
    -> decltype(addMeshLayer(acmap::firstRenderer(visualizer), vertices, mesh))
{
  return addMeshLayer(acmap::firstRenderer(visualizer), vertices, mesh, hide_backs);
}

template <typename Visualizer>
auto
addNormalLayer(Visualizer& visualizer,
               const PCLPointCloud2& vertices,
               const TriangleMesh& mesh)
    -> decltype(addNormalLayer(acmap::firstRenderer(visualizer), vertices, mesh))
{
  return addNormalLayer(acmap::firstRenderer(visualizer), vertices, mesh);
}

template <typename Visualizer>
auto
addPlaneLayer(Visualizer& visualizer, const CompactMap& map, bool hide_backs = false)
    -> decltype(addPlaneLayer(acmap::firstRenderer(visualizer), map))
{
  return addPlaneLayer(acmap::firstRenderer(visualizer), map, hide_backs);
}

template <typename Visualizer>
auto
addTextureLayer(Visualizer& visualizer, const CompactMap& map, bool hide_backs = false)
    -> decltype(addTextureLayer(acmap::firstRenderer(visualizer), map))
{
  return addTextureLayer(acmap::firstRenderer(visualizer), map, hide_backs);
}

template <typename Visualizer>
auto
addTrajectoryLayer(Visualizer& visualizer,
                   const Trajectory& trajectory,
                   double axis_length = 0.2)
    -> decltype(addTrajectoryLayer(acmap::firstRenderer(visualizer), trajectory))
{
  return addTrajectoryLayer(acmap::firstRenderer(visualizer), trajectory, axis_length);
}

} // namespace pcl
