#include "export/map_page_parts.h"

#include <pcl/core/impl/base64.h>
#include <pcl/core/impl/map_pictures.h>
#include <pcl/core/map_file.h>
#include <pcl/core/output_file.h>
#include <pcl/texture/map_page.h>

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <locale>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

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

/** The images of kinds that a map names, as an object of JSON: base64 by name. */
std::string
kindsOf(const CompactMap& map, const std::filesystem::path& folder)
{
  std::set<std::string> names;
  for (const TexturePicture* picture : acmap::picturesOf(map))
    if (!picture->kinds_image.empty())
      names.insert(picture->kinds_image);
  std::ostringstream text;
  text << '{';
  for (const std::string& name : names)
    text << (name == *names.begin() ? "" : ",") << std::quoted(name) << ":\""
         << acmap::base64(bytesOf(folder / name)) << '"';
  text << '}';
  return inScript(text.str());
}

} // namespace

bool
hasMapPage()
{
  return *acmap::mapPageScript() != 0;
}

void
saveMapPage(const std::string& path, const std::string& map, const Trajectory& before)
{
  if (!hasMapPage())
    throw acmap::InitFailed("acmap was built without the modules of its page for "
                            "browsers (ACMAP_PAGE_MODULES)");
  const std::filesystem::path folder(map);
  const std::string json = (folder / "map.json").string();
  const std::map<std::string_view, std::string> parts = {
      {"style", acmap::mapPageStyle()},
      {"script", acmap::mapPageScript()},
      {"map", inScript(bytesOf(json))},
      {"before", positionsOf(before)},
      {"kinds", kindsOf(loadMapFile(json), folder)},
      {"glb", acmap::base64(bytesOf(folder / "map.glb"))}};
  acmap::OutputFile page(path);
  // Marks are sought in the template alone: a part may contain braces.
  std::string_view rest = acmap::mapPageTemplate();
  for (std::size_t at = rest.find("{{"); at != std::string_view::npos;
       at = rest.find("{{")) {
    const std::size_t end = rest.find("}}", at);
    const std::string& part = parts.at(rest.substr(at + 2, end - at - 2));
    page.write(rest.data(), at);
    page.write(part.data(), part.size());
    rest.remove_prefix(end + 2);
  }
  page.write(rest.data(), rest.size());
  page.commit();
}

} // namespace pcl
