#include <pcl/texture/compact_map_folder.h>

#include "export/map_writers.h"

#include <pcl/core/map_file.h>
#include <pcl/core/output_file.h>
#include <pcl/core/output_folder.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <tuple>
#include <utility>

namespace pcl {

namespace {

using acmap::ChartSurface;
using acmap::OutputFolder;

constexpr const char* map_name = "map.json";

std::string
imageName(std::size_t chart, const char* end)
{
  char name[64];
  std::snprintf(name, sizeof(name), "texture_%04zu%s", chart, end);
  return name;
}

void
requireWholeCharts(const CompactMap& map)
{
  for (std::size_t i = 0; i < map.charts.size(); ++i) {
    const TextureChart& chart = map.charts[i];
    const auto texels = static_cast<std::uint64_t>(std::int64_t{chart.colors.width} *
                                                   chart.colors.height);
    if (chart.colors.values.size() != 3 * texels || chart.kinds.size() != texels)
      throw BadArgumentException("chart " + std::to_string(i) + " of a map has " +
                                 std::to_string(chart.colors.values.size()) +
                                 " values of colour and " +
                                 std::to_string(chart.kinds.size()) + " kinds for " +
                                 std::to_string(chart.colors.width) + " x " +
                                 std::to_string(chart.colors.height) + " texels");
  }
}

bool
isSeen(TexelKind kind)
{
  return kind == TexelKind::Seen;
}

/** \brief Assigns image names to the charts; restores the old names unless keep() is
 * called. */
class ImageNames {
public:
  ImageNames(std::vector<TextureChart>& charts, bool jpeg)
  : charts_(charts)
  {
    for (std::size_t i = 0; i < charts.size(); ++i) {
      TextureChart& chart = charts[i];
      before_.emplace_back(chart.image, chart.kinds_image);
      chart.image = imageName(i, jpeg ? ".jpg" : ".png");
      const bool all_seen =
          std::all_of(chart.kinds.begin(), chart.kinds.end(), &isSeen);
      chart.kinds_image = all_seen ? "" : imageName(i, "_kinds.png");
    }
  }

  ~ImageNames()
  {
    for (std::size_t i = 0; i < before_.size(); ++i)
      std::tie(charts_[i].image, charts_[i].kinds_image) = before_[i];
  }

  ImageNames(const ImageNames&) = delete;
  ImageNames&
  operator=(const ImageNames&) = delete;

  void
  keep()
  {
    before_.clear();
  }

private:
  std::vector<TextureChart>& charts_;
  std::vector<std::pair<std::string, std::string>> before_;
};

/** \brief Writes the files of a map into a folder that is renamed into place later. */
class MapFolderWriter {
public:
  MapFolderWriter(const OutputFolder& folder,
                  const CompactMap& map,
                  const CompactMapOutputs& outputs)
  : folder_(folder)
  , map_(map)
  , outputs_(outputs)
  {}

  std::vector<std::string>
  writeAll()
  {
    saveMapFile(place(map_name), map_);
    for (const TextureChart& chart : map_.charts)
      writeImages(chart);
    const std::vector<ChartSurface> surfaces = acmap::surfacesOf(map_);
    if (outputs_.obj) {
      acmap::writeObj(place("map.obj"), map_, surfaces);
      acmap::writeMtl(place(acmap::material_file_name), map_, surfaces);
    }
    if (outputs_.glb)
      acmap::writeGlb(place("map.glb"), map_, surfaces, outputs_.jpeg_quality);
    if (outputs_.vertex_ply)
      acmap::writeVertexPly(place("map.ply"), map_, surfaces);
    return names_;
  }

private:
  std::string
  place(const std::string& name)
  {
    names_.push_back(name);
    return folder_.path(name);
  }

  void
  writeBytes(const std::string& name, const std::vector<std::uint8_t>& bytes)
  {
    acmap::OutputFile file(place(name));
    file.write(bytes.data(), bytes.size());
    file.commit();
  }

  void
  writeImages(const TextureChart& chart)
  {
    const RgbImage image = acmap::withGrey(chart);
    writeBytes(chart.image,
               outputs_.jpeg_images ? encodeJpeg(image, outputs_.jpeg_quality)
                                    : encodePng(image));
    if (chart.kinds_image.empty())
      return;
    std::vector<std::uint8_t> kinds(chart.kinds.size());
    std::transform(chart.kinds.begin(),
                   chart.kinds.end(),
                   kinds.begin(),
                   [](TexelKind kind) { return static_cast<std::uint8_t>(kind); });
    writeBytes(chart.kinds_image, encodePng(image.width, image.height, kinds));
  }

  const OutputFolder& folder_;
  const CompactMap& map_;
  const CompactMapOutputs& outputs_;
  std::vector<std::string> names_;
};

} // namespace

RgbImage
acmap::withGrey(const TextureChart& chart)
{
  RgbImage image = chart.colors;
  for (std::size_t i = 0; i < chart.kinds.size(); ++i)
    if (chart.kinds[i] == TexelKind::None)
      std::fill_n(&image.values[3 * i], 3, unknown_grey);
  return image;
}

std::vector<std::string>
saveCompactMap(const std::string& folder,
               CompactMap& map,
               const CompactMapOutputs& outputs)
{
  if (outputs.jpeg_quality < 1 || outputs.jpeg_quality > 100)
    throw BadArgumentException(
        "jpeg_quality = " + std::to_string(outputs.jpeg_quality) +
        " is refused: it must be within [1, 100]");
  requireWholeCharts(map);
  ImageNames names(map.charts, outputs.jpeg_images);
  OutputFolder target(folder);
  const std::vector<std::string> written =
      MapFolderWriter(target, map, outputs).writeAll();
  target.commit();
  names.keep();
  return written;
}

} // namespace pcl
