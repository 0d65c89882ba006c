#include "atlas/chart_picture.h"

#include <pcl/core/image_file.h>
#include <pcl/core/impl/map_pictures.h>
#include <pcl/core/map_file.h>
#include <pcl/texture/compact_map_folder.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace pcl {

namespace {

namespace fs = std::filesystem;

/** \brief Reads the images to which a map refers. */
class ImageReader {
public:
  explicit ImageReader(const std::string& folder)
  : folder_(folder)
  , map_path_((fs::path(folder) / "map.json").string())
  {}

  const std::string&
  mapPath() const
  {
    return map_path_;
  }

  /** Reads the colours and kinds of the pictures. Each image is read once, and only one is
   * in memory at a time. */
  void
  read(CompactMap& map) const
  {
    std::map<std::string, std::vector<TexturePicture*>> of_image, of_kinds;
    for (TexturePicture* const picture : acmap::picturesOf(map)) {
      if (picture->image.empty())
        continue; // without colours
      of_image[picture->image].push_back(picture);
      if (!picture->kinds_image.empty())
        of_kinds[picture->kinds_image].push_back(picture);
    }
    for (const auto& [name, pictures] : of_image) {
      const std::string path = pathOf(name);
      const RgbImage image = loadRgbImage(path);
      for (TexturePicture* const picture : pictures)
        readColors(path, image, map.exposure, *picture);
    }
    for (const auto& [name, pictures] : of_kinds) {
      const std::string path = pathOf(name);
      const GrayImage16 image = loadGrayImage16(path);
      for (TexturePicture* const picture : pictures)
        readKinds(path, image, *picture);
    }
  }

private:
  static void
  readColors(const std::string& path,
             const RgbImage& image,
             double exposure,
             TexturePicture& chart)
  {
    const Eigen::Vector2i size = acmap::halvedSize(chart.colors, chart.halvings);
    const Eigen::Vector2i place =
        requirePlace(path, {image.width, image.height}, chart.image_place, size);
    RgbImage part{size.x(), size.y(), {}};
    for (std::int32_t row = 0; row < size.y(); ++row) {
      const std::uint8_t* const first = image.at(place.x(), place.y() + row);
      part.values.insert(
          part.values.end(), first, first + 3 * std::ptrdiff_t{size.x()});
    }
    acmap::enlarge(part, exposure, chart);
    chart.kinds.assign(chart.colors.values.size() / 3, TexelKind::Seen);
  }

  static void
  readKinds(const std::string& path, const GrayImage16& image, TexturePicture& chart)
  {
    const Eigen::Vector2i size(chart.colors.width, chart.colors.height);
    const Eigen::Vector2i place =
        requirePlace(path, {image.width, image.height}, chart.kinds_place, size);
    std::size_t texel = 0;
    for (std::int32_t row = 0; row < size.y(); ++row)
      for (std::int32_t column = 0; column < size.x(); ++column, ++texel) {
        const std::uint16_t kind = image.values[static_cast<std::size_t>(
            std::int64_t{place.y() + row} * image.width + place.x() + column)];
        if (kind > static_cast<std::uint16_t>(TexelKind::Filled))
          throw InputFileException(path + ": " + std::to_string(kind) +
                                   " is no kind of a texel");
        chart.kinds[texel] = static_cast<TexelKind>(kind);
        if (chart.kinds[texel] == TexelKind::None)
          std::fill_n(&chart.colors.values[3 * texel], 3, unknown_grey);
      }
  }

  /** Requires that images are directly in the folder, because maps can come from
   * untrusted sources. */
  std::string
  pathOf(const std::string& name) const
  {
    constexpr std::size_t longest = 255; // maximum length of a file name
    if (name.empty() || name == "." || name == ".." || name.size() > longest ||
        name.find_first_of(std::string("/\\\0", 3)) != std::string::npos)
      throw InputFileException(map_path_ + ": \"" + name.substr(0, longest) +
                               "\" is no name of an image in the folder");
    const fs::path path = fs::path(folder_) / name;
    std::error_code error;
    const fs::path target = fs::canonical(path, error); // reported later if missing
    if (!error && target.parent_path() != fs::canonical(folder_, error))
      throw InputFileException(path.string() + ": is a link to outside of the folder");
    return path.string();
  }

  /** Requires that a chart is inside of its image.
   * \param[in] place nothing if the image has no other texels
   * \return column and row of its first texel */
  static Eigen::Vector2i
  requirePlace(const std::string& path,
               const Eigen::Vector2i& image,
               const std::optional<Eigen::Vector2i>& place,
               const Eigen::Vector2i& size)
  {
    const auto text = [](const Eigen::Vector2i& v, const char* between) {
      return std::to_string(v.x()) + between + std::to_string(v.y());
    };
    const std::string fault = path + ": has " + text(image, " x ") +
                              " pixels, the map says " + text(size, " x ");
    if (!place && image != size)
      throw InputFileException(fault);
    // the difference cannot overflow
    if (place && (place->array() > image.array() - size.array()).any())
      throw InputFileException(fault + " of them at (" + text(*place, ", ") + ")");
    return place.value_or(Eigen::Vector2i::Zero());
  }

  std::string folder_;
  std::string map_path_;
};

} // namespace

CompactMap
loadCompactMap(const std::string& folder)
{
  const ImageReader images(folder);
  CompactMap map = loadMapFile(images.mapPath());
  images.read(map);
  return map;
}

} // namespace pcl
