#include "plane_outputs.h"

#include "cloud_labels.h"
#include "memory.h"

#include <pcl/core/cloud_fields.h>
#include <pcl/core/mesh_file.h>
#include <pcl/core/point_cloud_writer.h>

namespace pcl::acmap {

namespace {

PCLPointCloud2
withVotes(const PCLPointCloud2& cloud, const std::vector<VotedNormal>& votes)
{
  const char* const names[] = {"normal_x", "normal_y", "normal_z", "curvature"};
  std::vector<FieldWish> wishes;
  for (const char* name : names)
    wishes.push_back({name, PCLPointField::FLOAT32});
  wishes.push_back({"vertex_class", PCLPointField::UINT8});
  PCLPointCloud2 result = withFields(cloud, wishes);
  std::vector<std::size_t> offsets;
  for (const FieldWish& wish : wishes)
    offsets.push_back(findField(result, wish.name)->offset);
  for (std::size_t row = 0; row < votes.size(); ++row) {
    for (int axis = 0; axis < 3; ++axis)
      setValue(result,
               row,
               offsets[static_cast<std::size_t>(axis)],
               votes[row].normal[axis]);
    setValue(result, row, offsets[3], 1 - votes[row].saliency);
    setValue(
        result, row, offsets[4], static_cast<std::uint8_t>(votes[row].vertex_class));
  }
  return result;
}

} // namespace

void
saveLabels(const std::string& path,
           PointCloudFile file,
           const std::vector<std::int32_t>& planes)
{
  PCLPointCloud2 cloud = withLabels(std::move(file.cloud), planes);
  dropUnwritableFields(cloud);
  savePointCloud(path, cloud, file.sensor_origin, file.sensor_orientation);
}

void
saveNormals(const std::string& path,
            const HypothesisMesh& mesh,
            const std::vector<std::int32_t>& planes)
{
  saveTriangleMesh(
      path,
      withLabels(withVotes(mesh.vertices.cloud, mesh.votes.normals), planes),
      mesh.mesh);
}

SceneView
sceneViewOf(const HypothesisMesh& mesh)
{
  SceneView view;
  view.sensor_origin = mesh.vertices.sensor_origin;
  view.sensor_orientation = mesh.vertices.sensor_orientation;
  view.hide_backs = true;
  return view;
}

void
savePicture(const std::string& path,
            const HypothesisMesh& mesh,
            const std::vector<std::int32_t>& planes)
{
  const UnlimitedMemory while_drawing;
  saveSnapshot(path,
               coloredByLabel(withLabels(mesh.vertices.cloud, planes)),
               mesh.mesh,
               sceneViewOf(mesh));
}

} // namespace pcl::acmap
