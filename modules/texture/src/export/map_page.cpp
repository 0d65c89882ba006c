#include "export/map_page_images.h"
#include "export/map_page_parts.h"

#include <pcl/core/impl/base64.h>
#include <pcl/core/map_file.h>
#include <pcl/core/output_file.h>
#include <pcl/texture/map_page.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>
#include <map>
#include <sstream>
#include <string_view>

namespace pcl {

namespace {

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
  const CompactMap shown = loadMapFile(json);
  const std::map<std::string_view, std::string> parts = {
      {"style", acmap::mapPageStyle()},
      {"script", acmap::mapPageScript()},
      {"map", acmap::inScript(acmap::bytesOf(json))},
      {"before", positionsOf(before)},
      {"colours", acmap::hasSeenTexels(shown, folder) ? "seen" : "none"},
      {"kinds", acmap::kindsOf(shown, folder)},
      {"previews", acmap::previewsOf(shown, folder)},
      {"glb", acmap::base64(acmap::bytesOf(folder / "map.glb"))}};
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
