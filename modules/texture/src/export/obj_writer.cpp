#include "export/map_writers.h"

#include <pcl/core/impl/rigid_alignment.h>
#include <pcl/core/map_up.h>
#include <pcl/core/output_file.h>

#include <Eigen/Geometry>

#include <algorithm>
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

/** The name of what a surface is of. */
std::string
ownerOf(const ChartSurface& surface, const CompactMap& map)
{
  std::size_t number = surface.plane;
  if (number < map.planes.size())
    return "plane " + std::to_string(number);
  number -= map.planes.size();
  if (number < map.cylinders.size())
    return "cylinder " + std::to_string(number);
  return "box " + std::to_string(number - map.cylinders.size());
}

/** Vertices of a surface, with its owner as a comment. */
std::string
verticesOf(const ChartSurface& surface,
           const CompactMap& map,
           const Eigen::Matrix3d& turn)
{
  std::string text = "# " + ownerOf(surface, map) + "\n";
  for (const Eigen::Vector3d& point : surface.points) {
    const Eigen::Vector3d p = turn * point;
    text += "v " + textOf(p.x()) + " " + textOf(p.y()) + " " + textOf(p.z()) + "\n";
  }
  return text;
}

/** \param[in] first number of the first vertex, from 1
 * \param[in] is_textured have the vertices texture coordinates with the same numbers? */
std::string
facesOf(const ChartSurface& surface, std::size_t first, bool is_textured)
{
  std::string text;
  for (const TriangleMesh::Triangle& triangle : surface.triangles) {
    text += "f";
    for (const std::int32_t corner : triangle) {
      const std::string index =
          std::to_string(first + static_cast<std::size_t>(corner));
      text += " " + index + (is_textured ? "/" + index : "");
    }
    text += "\n";
  }
  return text;
}

std::string
coordinatesOf(const std::vector<ChartSurface>& surfaces,
              std::size_t number,
              const TextureAtlas& atlas)
{
  std::string text;
  for (const Eigen::Vector2d& place : surfaces[number].places) {
    const Eigen::Vector2d at = atlas.coordinates(number, place);
    text += "vt " + textOf(at.x()) + " " + textOf(1 - at.y()) + "\n";
  }
  return text;
}

/** The start of a group with a material of the same name. */
std::string
groupOf(const std::string& name)
{
  return "g " + name + "\nusemtl " + name + "\n";
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
  return smallestRotation(up, y).toRotationMatrix().array().round();
}

void
writeObj(const std::string& path,
         const CompactMap& map,
         const std::vector<ChartSurface>& surfaces,
         const std::vector<ChartSurface>& proposed,
         const TextureAtlas& atlas)
{
  OutputFile file(path);
  const Eigen::Matrix3d turn = turnToYUp(map);
  write(file,
        "# acmap: planes of a building; metres, y up: these are " + axesOf(turn) +
            " of the map's frame\nmtllib " + material_file_name + "\n");
  std::size_t first = 1;
  for (std::size_t page = 0; page < atlas.pages.size(); ++page) {
    write(file, groupOf(materialOf(page)));
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      if (atlas.places[i].page != page)
        continue;
      write(file,
            verticesOf(surfaces[i], map, turn) + coordinatesOf(surfaces, i, atlas) +
                facesOf(surfaces[i], first, true));
      first += surfaces[i].points.size();
    }
  }
  if (!proposed.empty())
    write(file, groupOf(proposed_layer::name));
  for (const ChartSurface& surface : proposed) {
    write(file, verticesOf(surface, map, turn) + facesOf(surface, first, false));
    first += surface.points.size();
  }
  file.commit();
}

void
writeMtl(const std::string& path,
         const CompactMap& map,
         const std::vector<std::string>& images,
         bool has_proposed)
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
  if (has_proposed) {
    using namespace proposed_layer;
    const auto color = [](double share) {
      return textOf(share * red) + " " + textOf(share * green) + " " +
             textOf(share * blue);
    };
    write(file,
          "newmtl " + std::string(name) + "\nKa " + color(0.3) + "\nKd " + color(0.7) +
              "\nKs 0 0 0\nillum 1\nd " + textOf(opacity) + "\n");
  }
  file.commit();
}

} // namespace pcl::acmap
