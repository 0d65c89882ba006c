#include "plane_outputs.h"

#include "cloud_labels.h"
#include "memory.h"

#include <pcl/core/cloud_fields.h>
#include <pcl/core/mesh_file.h>
#include <pcl/core/point_cloud_writer.h>

namespace pcl::acmap {

namespace {

PCLPointCloud2
withVotes(const MappedPlanes& found)
{
  const char* const names[] = {"normal_x", "normal_y", "normal_z", "curvature"};
  std::vector<FieldWish> wishes;
  for (const char* name : names)
    wishes.push_back({name, PCLPointField::FLOAT32});
  wishes.push_back({"vertex_class", PCLPointField::UINT8});
  PCLPointCloud2 result = withFields(found.vertices.cloud, wishes);
  std::vector<std::size_t> offsets;
  for (const FieldWish& wish : wishes)
    offsets.push_back(findField(result, wish.name)->offset);
  for (std::size_t row = 0; found.normals && row < found.normals->size(); ++row) {
    const Normal& normal = (*found.normals)[row];
    for (std::size_t axis = 0; axis < 3; ++axis)
      setValue(result, row, offsets[axis], normal.normal[axis]);
    setValue(result, row, offsets[3], normal.curvature);
    const std::uint32_t vertex_class = (*found.vertex_classes)[row].label;
    setValue(result, row, offsets[4], static_cast<std::uint8_t>(vertex_class));
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
saveNormals(const std::string& path, const MappedPlanes& found)
{
  saveTriangleMesh(path, withLabels(withVotes(found), found.vertex_labels), found.mesh);
}

SceneView
sceneViewOf(const MappedPlanes& found)
{
  SceneView view;
  view.sensor_origin = found.vertices.sensor_origin;
  view.sensor_orientation = found.vertices.sensor_orientation;
  view.hide_backs = true;
  return view;
}

void
savePicture(const std::string& path, const MappedPlanes& found)
{
  const UnlimitedMemory while_drawing;
  saveSnapshot(path,
               coloredByLabel(withLabels(found.vertices.cloud, found.vertex_labels)),
               found.mesh,
               sceneViewOf(found));
}

} // namespace pcl::acmap
