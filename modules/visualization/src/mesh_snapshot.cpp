#include <pcl/visualization/layered_scene.h>
#include <pcl/visualization/mesh_snapshot.h>

#include "scene.h"

namespace pcl {
namespace {

/** \brief A mesh, or a cloud if it has no triangles, as the only layer of a scene. */
LayeredScene
sceneOf(const PCLPointCloud2& cloud, const TriangleMesh& mesh)
{
  LayeredScene scene;
  (mesh.triangles.empty() ? scene.points : scene.vertices) = cloud;
  scene.mesh = mesh;
  return scene;
}

LayeredView
viewOf(const SceneView& view)
{
  LayeredView layered;
  static_cast<SceneView&>(layered) = view;
  return layered;
}

} // namespace

void
saveSnapshot(const std::string& path,
             const PCLPointCloud2& cloud,
             const TriangleMesh& mesh,
             const SceneView& view)
{
  saveSnapshot(path, sceneOf(cloud, mesh), viewOf(view));
}

void
saveSnapshot(const std::string& path, const PolygonMesh& mesh, const SceneView& view)
{
  saveSnapshot(path, mesh.cloud, acmap::trianglesOf(mesh), view);
}

void
showScene(const std::string& title,
          const PCLPointCloud2& cloud,
          const TriangleMesh& mesh,
          const SceneView& view)
{
  showScene(title, sceneOf(cloud, mesh), viewOf(view));
}

void
showScene(const std::string& title, const PolygonMesh& mesh, const SceneView& view)
{
  showScene(title, mesh.cloud, acmap::trianglesOf(mesh), view);
}

} // namespace pcl
