#include "export/map_writers.h"

#include <pcl/core/map_up.h>
#include <pcl/core/output_file.h>

#include <Eigen/Geometry>

#include <array>
#include <charconv>

namespace pcl::acmap {

namespace {

std::string
textOf(double value)
{
  std::array<char, 40> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value + 0.0) // avoids "-0"
          .ptr;
  return {text.data(), end};
}

std::string
materialOf(std::size_t page)
{
  return "page_" + std::to_string(page);
}

/** Expresses the rotated coordinates by the original ones, such as "x, -y, -z". */
std::string
axesOf(const Eigen::Matrix3d& turn)
{
  std::string text;
  for (Eigen::Index row = 0; row < 3; ++row)
    for (Eigen::Index column = 0; column < 3; ++column)
      if (turn(row, column) != 0)
        text += std::string(row > 0 ? ", " : "") + (turn(row, column) < 0 ? "-" : "") +
                "xyz"[column];
  return text;
}

/** Vertices, texture coordinates and faces of a surface; vertices and texture
 * coordinates have the same numbers. */
std::string
textOf(const std::vector<ChartSurface>& surfaces,
       std::size_t number,
       const TextureAtlas& atlas,
       const Eigen::Matrix3d& turn,
       std::size_t first)
{
  const ChartSurface& surface = surfaces[number];
  std::string text = "# plane " + std::to_string(surface.plane) + "\n";
  for (const Eigen::Vector3d& point : surface.points) {
    const Eigen::Vector3d p = turn * point;
    text += "v " + textOf(p.x()) + " " + textOf(p.y()) + " " + textOf(p.z()) + "\n";
  }
  for (const Eigen::Vector2d& place : surface.places) {
    const Eigen::Vector2d at = atlas.coordinates(number, place);
    text += "vt " + textOf(at.x()) + " " + textOf(1 - at.y()) + "\n";
  }
  for (const TriangleMesh::Triangle& triangle : surface.triangles) {
    text += "f";
    for (const std::int32_t corner : triangle) {
      const std::string index =
          std::to_string(first + static_cast<std::size_t>(corner));
      text += " " + index + "/" + index;
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

Eigen::Matrix3d
turnToYUp(const CompactMap& map)
{
  const Eigen::Vector3d up = upAxis(map), y = Eigen::Vector3d::UnitY();
  if (up == -y) // rotate about x, so that z points towards the viewer
    return Eigen::Vector3d(1, -1, -1).asDiagonal();
  return Eigen::Quaterniond::FromTwoVectors(up, y).toRotationMatrix().array().round();
}

void
writeObj(const std::string& path,
         const CompactMap& map,
         const std::vector<ChartSurface>& surfaces,
         const TextureAtlas& atlas)
{
  OutputFile file(path);
  const Eigen::Matrix3d turn = turnToYUp(map);
  write(file,
        "# acmap: planes of a building; metres, y up: these are " + axesOf(turn) +
            " of the map's frame\nmtllib " + material_file_name + "\n");
  std::size_t first = 1;
  for (std::size_t page = 0; page < atlas.pages.size(); ++page) {
    write(file, "g " + materialOf(page) + "\nusemtl " + materialOf(page) + "\n");
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      if (atlas.places[i].page != page)
        continue;
      write(file, textOf(surfaces, i, atlas, turn, first));
      first += surfaces[i].points.size();
    }
  }
  file.commit();
}

void
writeMtl(const std::string& path,
         const CompactMap& map,
         const std::vector<std::string>& images)
{
  OutputFile file(path);
  write(file,
        "# acmap: images of the planes, which contain their light; exposure " +
            textOf(map.exposure) + "\n");
  for (std::size_t page = 0; page < images.size(); ++page)
    write(file,
          "newmtl " + materialOf(page) +
              "\nKa 0.3 0.3 0.3\nKd 0.7 0.7 0.7\nKs 0 0 0\nillum 1\nmap_Kd " +
              images[page] + "\n");
  file.commit();
}

} // namespace pcl::acmap
