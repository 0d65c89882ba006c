#include <pcl/core/mesh_file.h>

#include "byte_source.h"
#include "mesh_codecs.h"
#include "text_number.h"

#include <pcl/exceptions.h>

namespace pcl {

namespace {

void
requireConsistent(const PCLPointCloud2& cloud, const TriangleMesh& mesh)
{
  const std::size_t points = std::size_t{cloud.width} * cloud.height;
  for (const TriangleMesh::Triangle& triangle : mesh.triangles)
    for (const std::int32_t corner : triangle)
      if (corner < 0 || static_cast<std::size_t>(corner) >= points)
        throw BadArgumentException("a triangle has the corner " +
                                   std::to_string(corner) + " in a cloud of " +
                                   std::to_string(points) + " points");
  if (!mesh.wall_depth.empty() && mesh.wall_depth.size() != mesh.triangles.size())
    throw BadArgumentException(
        "wall_depth has " + std::to_string(mesh.wall_depth.size()) + " entries for " +
        std::to_string(mesh.triangles.size()) + " triangles");
}

} // namespace

void
saveTriangleMesh(const std::string& path,
                 const PCLPointCloud2& cloud,
                 const TriangleMesh& mesh)
{
  const std::string ending = acmap::lowerEnding(path);
  if (ending != ".ply" && ending != ".vtk")
    throw OutputFileException(path + ": ending '" + ending +
                              "' is not known; ply and vtk are");
  const acmap::MeshColumns columns = acmap::sortColumns(cloud);
  requireConsistent(cloud, mesh);
  acmap::OutputFile file(path);
  if (ending == ".ply")
    acmap::writePly(file, cloud, columns, mesh);
  else
    acmap::writeVtk(file, cloud, columns, mesh);
  file.commit();
}

TriangleMesh
loadTriangleMesh(const std::string& path)
{
  const std::string ending = acmap::lowerEnding(path);
  if (ending != ".ply" && ending != ".obj")
    throw InputFileException(path + ": ending '" + ending +
                             "' is not known for a mesh; ply and obj are");
  acmap::ByteSource source(path);
  return ending == ".ply" ? acmap::readPlyFaces(source) : acmap::readObjFaces(source);
}

} // namespace pcl
