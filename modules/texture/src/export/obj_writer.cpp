#include "export/map_writers.h"

#include <pcl/core/output_file.h>

#include <array>
#include <charconv>

namespace pcl::acmap {

namespace {

std::string
textOf(double value)
{
  std::array<char, 40> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string
materialOf(const ChartSurface& surface)
{
  return surface.chart == ChartSurface::no_chart
             ? "untextured"
             : "chart_" + std::to_string(surface.chart);
}

/** Vertices, texture coordinates and faces of a surface; both count alike. */
std::string
textOf(const ChartSurface& surface, const CompactMap& map, std::size_t first)
{
  std::string text = "g plane_" + std::to_string(surface.plane) + "_" +
                     materialOf(surface) + "\nusemtl " + materialOf(surface) + "\n";
  for (const Eigen::Vector3d& p : surface.points)
    text += "v " + textOf(p.x()) + " " + textOf(p.y()) + " " + textOf(p.z()) + "\n";
  double width = 1;
  double height = 1;
  if (surface.chart != ChartSurface::no_chart) {
    width = map.charts[surface.chart].colors.width;
    height = map.charts[surface.chart].colors.height;
  }
  for (const Eigen::Vector2d& place : surface.places)
    text +=
        "vt " + textOf(place.x() / width) + " " + textOf(1 - place.y() / height) + "\n";
  for (const TriangleMesh::Triangle& triangle : surface.triangles) {
    text += "f";
    for (const std::int32_t corner : triangle) {
      const std::string number =
          std::to_string(first + static_cast<std::size_t>(corner));
      text += " " + number + "/" + number;
    }
    text += "\n";
  }
  return text;
}

void
write(OutputFile& file, const std::string& text)
{
  file.write(text.data(), text.size());
}

} // namespace

void
writeObj(const std::string& path,
         const CompactMap& map,
         const std::vector<ChartSurface>& surfaces)
{
  OutputFile file(path);
  write(file,
        "# acmap: planes of a building; metres, y down in the frame of the map\n"
        "mtllib " +
            std::string(material_file_name) + "\n");
  std::size_t first = 1;
  for (const ChartSurface& surface : surfaces) {
    write(file, textOf(surface, map, first));
    first += surface.points.size();
  }
  file.commit();
}

void
writeMtl(const std::string& path,
         const CompactMap& map,
         const std::vector<ChartSurface>& surfaces)
{
  OutputFile file(path);
  write(file, "# acmap: images of the planes, to be shown unlit\n");
  bool has_untextured = false;
  for (const ChartSurface& surface : surfaces) {
    if (surface.chart == ChartSurface::no_chart)
      has_untextured = true;
    else
      write(file,
            "newmtl " + materialOf(surface) +
                "\nKa 1 1 1\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd " +
                map.charts[surface.chart].image + "\n");
  }
  if (has_untextured)
    write(file,
          "newmtl untextured\nKa 0.5 0.5 0.5\nKd 0.5 0.5 0.5\nKs 0 0 0\nillum 1\n");
  file.commit();
}

} // namespace pcl::acmap
