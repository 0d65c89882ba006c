#include <pcl/visualization/map_layers.h>

#include "map_actors.h"
#include "scene_renderer.h"

#include <pcl/core/impl/arguments.h>

namespace pcl {
namespace {

using namespace acmap;

vtkProp*
add(vtkRenderer& renderer, const Actors& actors)
{
  const auto assembly = assemblyOf(actors);
  renderer.AddActor(assembly);
  return assembly;
}

} // namespace

vtkProp*
addPointLayer(vtkRenderer& renderer, const PCLPointCloud2& cloud)
{
  return add(renderer, {actorOfPoints(makeScene(cloud, {}))});
}

vtkProp*
addMeshLayer(vtkRenderer& renderer,
             const PCLPointCloud2& vertices,
             const TriangleMesh& mesh,
             bool hide_backs)
{
  return add(renderer, actorsOfMesh(makeScene(vertices, mesh), hide_backs));
}

vtkProp*
addNormalLayer(vtkRenderer& renderer,
               const PCLPointCloud2& vertices,
               const TriangleMesh& mesh)
{
  return add(renderer, {actorOfNormals(makeScene(vertices, mesh))});
}

vtkProp*
addPlaneLayer(vtkRenderer& renderer, const CompactMap& map, bool hide_backs)
{
  Actors actors = actorsOfPlanes(facesOf(map), hide_backs, layer_opacity);
  std::vector<MapLine> lines;
  for (std::size_t plane = 0; plane < map.planes.size(); ++plane)
    append(lines, outlinesOf(map, plane));
  for (std::size_t i = 0; i < map.cylinders.size(); ++i)
    append(lines, rimOf(map, i));
  actors.push_back(actorOfOutlines(lines));
  return add(renderer, actors);
}

vtkProp*
addTextureLayer(vtkRenderer& renderer, const CompactMap& map, bool hide_backs)
{
  return add(renderer,
             actorsOfTextures(cutFaces(map, facesOf(map)), map.exposure, hide_backs));
}

vtkProp*
addTrajectoryLayer(vtkRenderer& renderer,
                   const Trajectory& trajectory,
                   double axis_length)
{
  requireInRange("axis_length", axis_length, 1e-6, 1e6, "m");
  return add(renderer, actorsOfTrajectory(trajectory, axis_length));
}

} // namespace pcl
