#include "export/map_writers.h"
#include "texturing/canvas_surface.h"

#include <pcl/PCLPointField.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/mesh_file.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace pcl::acmap {

namespace {

constexpr std::int32_t none = -1;

/** \brief The vertices and faces of all pictures. */
struct VertexGrid {
  std::vector<std::uint8_t> data; ///< x y z rgb
  std::size_t vertices = 0;
  TriangleMesh mesh;

  static constexpr std::size_t step = 16;

  /** All vertices form one row, and the size of a row in bytes is a 32 bit number in a
   * cloud. */
  static constexpr std::size_t maximum =
      std::numeric_limits<std::uint32_t>::max() / step;

  std::int32_t
  appendVertex(const Eigen::Vector3f& place, const std::uint8_t* color)
  {
    if (vertices == maximum)
      throw acmap::BadArgument("a map has more than 2^28 - 1 texels for map.ply");
    const std::uint8_t packed[4] = {color[2], color[1], color[0], 255};
    data.resize(data.size() + step);
    std::memcpy(&data[vertices * step], place.data(), 12);
    std::memcpy(&data[vertices * step + 12], packed, 4);
    return static_cast<std::int32_t>(vertices++);
  }

  void
  append(const TexturePicture& picture,
         const texturing::CanvasSurface& shape,
         const ChartSurface& surface);
};

void
VertexGrid::append(const TexturePicture& picture,
                   const texturing::CanvasSurface& shape,
                   const ChartSurface& surface)
{
  const RgbImage& image = picture.colors;
  const std::vector<bool> cover = coverOf(surface, image);
  const auto width = static_cast<std::size_t>(image.width);
  // vertices of the previous and of the current row
  std::vector<std::int32_t> above(width, none);
  std::vector<std::int32_t> row_vertices(width, none);
  for (std::int32_t row = 0; row < image.height; ++row) {
    for (std::size_t i = 0; i < width; ++i) {
      const std::size_t texel = static_cast<std::size_t>(row) * width + i;
      row_vertices[i] = none;
      if (cover[texel] && picture.kinds[texel] != TexelKind::None)
        row_vertices[i] =
            appendVertex(shape.middleOf(static_cast<double>(i), row).cast<float>(),
                         &image.values[3 * texel]);
      if (i == 0)
        continue;
      const std::int32_t quad[4] = {
          above[i - 1], above[i], row_vertices[i], row_vertices[i - 1]};
      if (std::find(quad, quad + 4, none) != quad + 4)
        continue;
      mesh.triangles.push_back({quad[0], quad[1], quad[2]});
      mesh.triangles.push_back({quad[0], quad[2], quad[3]});
    }
    above.swap(row_vertices);
  }
}

PCLPointField
fieldOf(const std::string& name, std::uint32_t offset)
{
  PCLPointField field;
  field.name = name;
  field.offset = offset;
  field.datatype = PCLPointField::FLOAT32;
  field.count = 1;
  return field;
}

} // namespace

void
writeVertexPly(const std::string& path,
               const CompactMap& map,
               const std::vector<ChartSurface>& surfaces)
{
  VertexGrid grid;
  for (const ChartSurface& surface : surfaces) {
    if (surface.chart == ChartSurface::no_chart)
      continue;
    const std::size_t first = grid.mesh.triangles.size();
    bool is_left_handed = true; // columns to the right, rows downwards
    if (surface.chart < map.charts.size()) {
      const TextureChart& chart = map.charts[surface.chart];
      grid.append(chart, {chart, map.planes[chart.plane]}, surface);
      is_left_handed = chart.texel_u.cross(chart.texel_v).dot(surface.normal) < 0;
    }
    else {
      const std::size_t cylinder = surface.chart - map.charts.size();
      const TexturePicture& picture = map.cylinder_pictures[cylinder];
      grid.append(picture, {map.cylinders[cylinder], picture.colors}, surface);
    }
    if (is_left_handed)
      for (std::size_t i = first; i < grid.mesh.triangles.size(); ++i)
        std::swap(grid.mesh.triangles[i][1], grid.mesh.triangles[i][2]);
  }
  PCLPointCloud2 cloud;
  cloud.fields = {
      fieldOf("x", 0), fieldOf("y", 4), fieldOf("z", 8), fieldOf("rgb", 12)};
  cloud.point_step = VertexGrid::step;
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(grid.vertices);
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.data = std::move(grid.data);
  saveTriangleMesh(path, cloud, grid.mesh);
}

} // namespace pcl::acmap
