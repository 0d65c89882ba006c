#include <pcl/core/image_file.h>
#include <pcl/core/map_file.h>
#include <pcl/texture/compact_map_folder.h>

#include <filesystem>

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

  void
  read(TextureChart& chart) const
  {
    if (chart.image.empty())
      return; // a chart without colours
    const std::string path = pathOf(chart.image);
    RgbImage image = loadRgbImage(path);
    requireSize(path, image.width, image.height, chart);
    chart.colors = std::move(image);
    const std::size_t texels = chart.colors.values.size() / 3;
    chart.kinds.assign(texels, TexelKind::Seen);
    if (!chart.kinds_image.empty())
      readKinds(chart);
  }

private:
  void
  readKinds(TextureChart& chart) const
  {
    const std::string path = pathOf(chart.kinds_image);
    const GrayImage16 kinds = loadGrayImage16(path);
    requireSize(path, kinds.width, kinds.height, chart);
    for (std::size_t i = 0; i < kinds.values.size(); ++i) {
      if (kinds.values[i] > static_cast<std::uint16_t>(TexelKind::Filled))
        throw InputFileException(path + ": " + std::to_string(kinds.values[i]) +
                                 " is no kind of a texel");
      chart.kinds[i] = static_cast<TexelKind>(kinds.values[i]);
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

  static void
  requireSize(const std::string& path,
              std::int32_t width,
              std::int32_t height,
              const TextureChart& chart)
  {
    const auto text = [](std::int32_t columns, std::int32_t rows) {
      return std::to_string(columns) + " x " + std::to_string(rows);
    };
    if (width != chart.colors.width || height != chart.colors.height)
      throw InputFileException(path + ": has " + text(width, height) +
                               " pixels, the map says " +
                               text(chart.colors.width, chart.colors.height));
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
  for (TextureChart& chart : map.charts)
    images.read(chart);
  return map;
}

} // namespace pcl
