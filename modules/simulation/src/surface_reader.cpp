#include "surface_reader.h"

#include "yaml_values.h"

#include <map>

namespace pcl::acmap {

namespace {

constexpr std::size_t max_items = 10000; // per list of the file

using Looks = std::map<std::string, SurfaceLook>;

SurfaceLook
readLook(const YamlNode& node)
{
  constexpr double strongest_texture = 255.0;
  constexpr std::size_t brightest = 255;
  node.requireKeys({"color", "texture"});
  SurfaceLook look;
  const auto& channels = node.at("color").list(3, 3);
  for (std::size_t i = 0; i < look.color.size(); ++i)
    look.color[i] = static_cast<std::uint8_t>(channels[i].count(0, brightest));
  look.texture = node.at("texture").number(0.0, strongest_texture);
  return look;
}

/** \brief Adds the surfaces of a file to a scene, in order. */
class SurfaceReader {
public:
  explicit SurfaceReader(Looks looks)
  : looks_(std::move(looks))
  {}

  void
  add(const YamlNode& item)
  {
    const YamlNode& key = onlyKeyOf(item);
    const YamlNode& surface = item.at(key.text());
    atLineOf(key, [&] {
      if (key.text() == "rectangle")
        addRectangle(surface);
      else if (key.text() == "box")
        addBox(surface);
      else if (key.text() == "cylinder")
        addCylinder(surface);
      else
        key.fail("'" + key.text() + "' is no surface; rectangle, box and cylinder are");
    });
  }

  SceneGeometry
  take()
  {
    return std::move(geometry_);
  }

private:
  const SurfaceLook&
  lookOf(const YamlNode& name) const
  {
    const auto look = looks_.find(name.text());
    if (look == looks_.end())
      name.fail("'" + name.text() + "' is none of the looks of this scene");
    return look->second;
  }

  void
  addRectangle(const YamlNode& node)
  {
    node.requireKeys({"name", "plane", "corner", "edges", "look", "openings"});
    const std::string& name = node.at("name").text();
    const YamlNode* const plane = node.find("plane");
    const std::string& plane_name = plane ? plane->text() : name;
    const auto& edges = node.at("edges").list(2, 2);
    const SimulatedRectangle rectangle{
        vectorOf(node.at("corner")), vectorOf(edges[0]), vectorOf(edges[1])};
    const SurfaceLook& look = lookOf(node.at("look"));
    if (const YamlNode* const openings = node.find("openings"))
      geometry_.addWall(name, plane_name, rectangle, look, readOpenings(*openings));
    else
      geometry_.addRectangle(name, plane_name, rectangle, look);
  }

  WallOpenings
  readOpenings(const YamlNode& node) const
  {
    node.requireKeys(
        {"name", "at", "width", "height", "depth", "panel", "reveal", "floor"});
    WallOpenings openings;
    openings.name = node.at("name").text();
    for (const YamlNode& at : node.at("at").list(1, max_items))
      openings.at.push_back(at.number(0.0, farthest_place));
    openings.width = node.at("width").number(0.0, farthest_place);
    openings.height = node.at("height").number(0.0, farthest_place);
    openings.depth = node.at("depth").number(0.0, farthest_place);
    openings.panel = lookOf(node.at("panel"));
    openings.reveal = lookOf(node.at("reveal"));
    openings.floor = node.at("floor").text();
    return openings;
  }

  static BoxFaces
  readFaces(const YamlNode& node)
  {
    constexpr std::size_t faces_of_a_box = 6;
    BoxFaces faces{false, false, false, false, false, false};
    const std::map<std::string, bool*> names = {{"left", &faces.left},
                                                {"right", &faces.right},
                                                {"top", &faces.top},
                                                {"bottom", &faces.bottom},
                                                {"front", &faces.front},
                                                {"back", &faces.back}};
    for (const YamlNode& name : node.list(1, faces_of_a_box)) {
      const auto face = names.find(name.text());
      if (face == names.end())
        name.fail("'" + name.text() +
                  "' is no face; left, right, top, bottom, front and back are");
      *face->second = true;
    }
    return faces;
  }

  void
  addBox(const YamlNode& node)
  {
    node.requireKeys({"name", "least", "most", "look", "faces"});
    const YamlNode* const faces = node.find("faces");
    geometry_.addBox(node.at("name").text(),
                     vectorOf(node.at("least")),
                     vectorOf(node.at("most")),
                     lookOf(node.at("look")),
                     faces ? readFaces(*faces) : BoxFaces{});
  }

  void
  addCylinder(const YamlNode& node)
  {
    node.requireKeys({"name", "base", "axis", "radius", "look", "caps"});
    const YamlNode* const caps = node.find("caps");
    const SimulatedCylinder cylinder{vectorOf(node.at("base")),
                                     vectorOf(node.at("axis")),
                                     node.at("radius").number(0.0, farthest_place)};
    geometry_.addCylinder(node.at("name").text(),
                          cylinder,
                          lookOf(node.at("look")),
                          caps && caps->boolean());
  }

  Looks looks_;
  SceneGeometry geometry_;
};

} // namespace

SceneGeometry
readSurfaces(const YamlNode& scene)
{
  Looks looks;
  const YamlNode& look_map = scene.at("looks");
  for (const YamlNode& name : look_map.keys())
    looks.emplace(name.text(), readLook(look_map.at(name.text())));
  SurfaceReader reader(std::move(looks));
  for (const YamlNode& item : scene.at("surfaces").list(1, max_items))
    reader.add(item);
  return reader.take();
}

} // namespace pcl::acmap
