#include "export/map_page_images.h"

#include <pcl/core/image_file.h>
#include <pcl/core/impl/base64.h>
#include <pcl/core/impl/map_pictures.h>

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <vector>

namespace pcl::acmap {

namespace {

/** An object of JSON: values, which are JSON themselves, by their names. */
std::string
objectOf(const std::map<std::string, std::string>& values)
{
  std::ostringstream text;
  text << '{';
  for (const auto& [name, value] : values)
    text << (name == values.begin()->first ? "" : ",") << std::quoted(name) << ':'
         << value;
  text << '}';
  return inScript(text.str());
}

/** An image with an eighth of its sides: means of 8 x 8 texels. */
RgbImage
shrunk(const RgbImage& image)
{
  constexpr std::int32_t share = 8;
  RgbImage small;
  small.width = std::max(1, image.width / share);
  small.height = std::max(1, image.height / share);
  const std::int32_t columns = std::min(share, image.width);
  const std::int32_t rows = std::min(share, image.height);
  for (std::int32_t row = 0; row < small.height; ++row)
    for (std::int32_t column = 0; column < small.width; ++column)
      for (std::int32_t channel = 0; channel < 3; ++channel) {
        std::int32_t sum = 0;
        for (std::int32_t j = 0; j < rows; ++j)
          for (std::int32_t i = 0; i < columns; ++i)
            sum += image.at(share * column + i, share * row + j)[channel];
        small.values.push_back(static_cast<std::uint8_t>(sum / (rows * columns)));
      }
  return small;
}

} // namespace

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

std::string
inScript(std::string json)
{
  for (std::size_t at = json.find('<'); at != std::string::npos;
       at = json.find('<', at))
    json.replace(at, 1, "\\u003c");
  return json;
}

bool
hasSeenTexels(const CompactMap& map, const std::filesystem::path& folder)
{
  std::set<std::string> names;
  for (const TexturePicture* picture : acmap::picturesOf(map))
    if (!picture->kinds_image.empty())
      names.insert(picture->kinds_image);
  return names.empty() ||
         std::any_of(names.begin(), names.end(), [&](const std::string& name) {
           const std::vector<std::uint16_t> kinds =
               loadGrayImage16((folder / name).string()).values;
           return std::any_of(
               kinds.begin(), kinds.end(), [](std::uint16_t kind) { return kind > 0; });
         });
}

std::string
kindsOf(const CompactMap& map, const std::filesystem::path& folder)
{
  std::map<std::string, std::string> kinds;
  for (const TexturePicture* picture : acmap::picturesOf(map))
    if (const std::string& name = picture->kinds_image; !name.empty())
      if (std::string& kind = kinds[name]; kind.empty())
        kind = '"' + acmap::base64(bytesOf(folder / name)) + '"';
  return objectOf(kinds);
}

std::string
previewsOf(const CompactMap& map, const std::filesystem::path& folder)
{
  constexpr std::size_t large = 500000; // texels
  constexpr int quality = 75;
  std::map<std::string, std::string> previews;
  std::set<std::string> names;
  for (const TexturePicture* picture : acmap::picturesOf(map))
    if (!picture->image.empty())
      names.insert(picture->image);
  for (const std::string& name : names) {
    const RgbImage page = loadRgbImage((folder / name).string());
    if (page.values.size() / 3 < large)
      continue;
    const std::vector<std::uint8_t> jpeg = encodeJpeg(shrunk(page), quality);
    previews[name] =
        "{\"size\":[" + std::to_string(page.width) + ',' + std::to_string(page.height) +
        "],\"jpeg\":\"" +
        acmap::base64({reinterpret_cast<const char*>(jpeg.data()), jpeg.size()}) +
        "\"}";
  }
  return objectOf(previews);
}

} // namespace pcl::acmap
