#include <pcl/core/mesh_file.h>

#include "clouds/mesh_codecs.h"
#include "files/byte_source.h"
#include "files/text_number.h"

#include <pcl/core/exceptions.h>

namespace pcl {

namespace {

void
requireConsistent(std::size_t points, const TriangleMesh& mesh)
{
  for (const TriangleMesh::Triangle& triangle : mesh.triangles)
    for (const std::int32_t corner : triangle)
      if (corner < 0 || static_cast<std::size_t>(corner) >= points)
        throw acmap::BadArgument("a triangle has the corner " + std::to_string(corner) +
                                 " in a cloud of " + std::to_string(points) +
                                 " points");
  if (!mesh.wall_depth.empty() && mesh.wall_depth.size() != mesh.triangles.size())
    throw acmap::BadArgument("wall_depth has " +
                             std::to_string(mesh.wall_depth.size()) + " entries for " +
                             std::to_string(mesh.triangles.size()) + " triangles");
}

} // namespace

void
saveTriangleMesh(const std::string& path,
                 const CloudRows& cloud,
                 const TriangleMesh& mesh)
{
  const std::string ending = acmap::lowerEnding(path);
  if (ending != ".ply" && ending != ".vtk")
    throw OutputFileException(path + ": ending '" + ending +
                              "' is not known; ply and vtk are");
  if (!cloud)
    throw acmap::BadArgument(path + ": there is no cloud to write");
  const acmap::MeshColumns columns = acmap::sortColumns(cloud);
  requireConsistent(cloud.size(), mesh);
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
