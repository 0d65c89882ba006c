#include <pcl/common/io.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/mesh_file.h>
#include <pcl/pipeline/mapped_planes.h>

#include <cstring>

namespace pcl {

namespace {

/** Labels of planes, followed by those of cylinders. */
std::vector<std::int32_t>
joinedLabels(const PointLabels& planes,
             const PointLabels& cylinders,
             std::size_t number_of_planes)
{
  std::vector<std::int32_t> labels(planes.begin(), planes.end());
  for (std::size_t i = 0; i < cylinders.size(); ++i)
    if (cylinders[i] >= 0)
      labels[i] = static_cast<std::int32_t>(number_of_planes) + cylinders[i];
  return labels;
}

/** Writes the votes of a vertex and its label into the row of a vertex. */
class VoteWriter {
public:
  explicit VoteWriter(const MappedPlanes& found)
  : found_(found)
  {
    for (const PCLPointField& field : found.normals.layout().fields)
      wishes_.push_back({field.name, field.datatype});
    wishes_.push_back({"label", PCLPointField::UINT32});
    const PCLPointCloud2 layout = acmap::layoutWith(found.vertices.layout(), wishes_);
    for (const acmap::FieldWish& wish : wishes_)
      offsets_.push_back(acmap::findField(layout, wish.name)->offset);
  }

  const std::vector<acmap::FieldWish>&
  wishes() const
  {
    return wishes_;
  }

  void
  operator()(std::uint8_t* row, std::size_t vertex) const
  {
    const PCLPointCloud2& votes = found_.normals.layout();
    const std::uint8_t* const from = found_.normals.data() + vertex * votes.point_step;
    for (std::size_t f = 0; f < votes.fields.size(); ++f) {
      const PCLPointField& field = votes.fields[f];
      std::memcpy(row + offsets_[f], from + field.offset, getFieldSize(field.datatype));
    }
    const std::int32_t cylinder =
        found_.vertex_cylinders.empty() ? -1 : found_.vertex_cylinders[vertex];
    const auto label = static_cast<std::uint32_t>(
        1 + (cylinder < 0
                 ? found_.vertex_labels[vertex]
                 : static_cast<std::int32_t>(found_.planes.size()) + cylinder));
    std::memcpy(row + offsets_.back(), &label, sizeof label);
  }

private:
  const MappedPlanes& found_;
  std::vector<acmap::FieldWish> wishes_;
  std::vector<std::size_t> offsets_;
};

} // namespace

CompactMap
mapOf(const MappedPlanes& found)
{
  CompactMap map;
  map.planes = found.planes;
  map.cylinders = found.cylinders;
  map.boxes = found.boxes;
  map.recesses = found.recesses;
  if (found.up)
    map.up = found.up->cast<double>().normalized();
  map.assumed_up = found.assumed_up.cast<double>();
  return map;
}

std::vector<std::int32_t>
labelsOf(const MappedPlanes& found)
{
  return joinedLabels(found.labels, found.cylinder_labels, found.planes.size());
}

std::vector<std::int32_t>
labelsOfVertices(const MappedPlanes& found)
{
  return joinedLabels(found.vertex_labels, found.vertex_cylinders, found.planes.size());
}

void
saveMappedMesh(const std::string& path, const MappedPlanes& found)
{
  const VoteWriter write(found);
  saveTriangleMesh(
      path, acmap::rowsWith(found.vertices, write.wishes(), write), found.mesh);
}

} // namespace pcl
