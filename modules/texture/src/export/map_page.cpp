#include "export/map_page_parts.h"

#include <pcl/core/impl/base64.h>
#include <pcl/core/output_file.h>
#include <pcl/texture/map_page.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>
#include <sstream>
#include <string_view>
#include <utility>

namespace pcl {

namespace {

/** \throws InputFileException when it cannot be read */
std::string
bytesOf(const std::filesystem::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(stream)),
                    std::istreambuf_iterator<char>());
  if (!stream || bytes.empty())
    throw InputFileException(path.string() + ": cannot be read");
  return bytes;
}

/** JSON as the content of a script element: no text in it ends the element. */
std::string
inScript(std::string json)
{
  for (std::size_t at = json.find('<'); at != std::string::npos;
       at = json.find('<', at))
    json.replace(at, 1, "\\u003c");
  return json;
}

std::string
positionsOf(const Trajectory& trajectory)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << '[';
  for (std::size_t i = 0; i < trajectory.poses.size(); ++i) {
    const Eigen::Vector3d place = trajectory.poses[i].translation();
    text << (i > 0 ? "," : "") << '[' << place.x() << ',' << place.y() << ','
         << place.z() << ']';
  }
  text << ']';
  return text.str();
}

} // namespace

void
saveMapPage(const std::string& path, const std::string& map, const Trajectory& before)
{
  const std::filesystem::path folder(map);
  const std::pair<std::string_view, std::string> parts[] = {
      {"three", acmap::threeScript()},
      {"gltf_loader", acmap::gltfLoaderScript()},
      {"orbit_controls", acmap::orbitControlsScript()},
      {"map", inScript(bytesOf(folder / "map.json"))},
      {"before", positionsOf(before)},
      {"glb", acmap::base64(bytesOf(folder / "map.glb"))}};
  acmap::OutputFile page(path);
  std::string_view rest = acmap::mapPageTemplate();
  for (const auto& [name, text] : parts) {
    const std::string mark = "{{" + std::string(name) + "}}";
    const std::size_t at = rest.find(mark);
    page.write(rest.data(), at);
    page.write(text.data(), text.size());
    rest.remove_prefix(at + mark.size());
  }
  page.write(rest.data(), rest.size());
  page.commit();
}

} // namespace pcl
