#include <pcl/core/exceptions.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/texture/compact_map_folder.h>

#include "export/map_writers.h"

#include <pcl/core/impl/map_check.h>
#include <pcl/core/impl/map_pictures.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/map_file.h>
#include <pcl/core/map_up.h>
#include <pcl/core/output_file.h>
#include <pcl/core/output_folder.h>
#include <pcl/core/progress.h>

#include <optional>
#include <tuple>
#include <utility>

namespace pcl {

namespace {

using acmap::KindAtlas;
using acmap::OutputFolder;
using acmap::TextureAtlas;

constexpr const char* map_name = "map.json";

std::vector<std::string>
pageNames(const std::string& what, std::size_t pages, const char* end)
{
  std::vector<std::string> names;
  for (std::size_t page = 0; page < pages; ++page)
    names.push_back(what + "_" + std::to_string(page) + end);
  return names;
}

void
requireWholeCharts(const CompactMap& map)
{
  const std::vector<const TexturePicture*> pictures = acmap::picturesOf(map);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const RgbImage& colors = pictures[i]->colors;
    const std::vector<TexelKind>& kinds = pictures[i]->kinds;
    const auto texels =
        static_cast<std::uint64_t>(std::int64_t{colors.width} * colors.height);
    if (colors.values.size() == 3 * texels && kinds.size() == texels)
      continue;
    const std::size_t charts = map.charts.size();
    throw acmap::BadArgument(
        (i < charts ? "chart " + std::to_string(i)
                    : "the picture of cylinder " + std::to_string(i - charts)) +
        " of a map has " + std::to_string(colors.values.size()) +
        " values of colour and " + std::to_string(kinds.size()) + " kinds for " +
        acmap::sizeText(colors) + " texels");
  }
}

/** \brief Sets where the pictures of a map are in the pages; restores the old places unless keep()
 * is called. */
class PicturePlaces {
public:
  explicit PicturePlaces(CompactMap& map)
  : pictures_(acmap::picturesOf(map))
  {
    for (const TexturePicture* const picture : pictures_)
      before_.emplace_back(picture->image,
                           picture->image_place,
                           picture->halvings,
                           picture->kinds_image,
                           picture->kinds_place);
  }

  ~PicturePlaces()
  {
    for (std::size_t i = 0; i < before_.size(); ++i)
      placesOf(*pictures_[i]) = before_[i];
  }

  PicturePlaces(const PicturePlaces&) = delete;
  PicturePlaces&
  operator=(const PicturePlaces&) = delete;

  /** \param[in] images file name of each page */
  void
  set(const std::vector<acmap::ChartSurface>& surfaces,
      const TextureAtlas& atlas,
      const std::vector<std::string>& images)
  {
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      if (surfaces[i].chart == acmap::ChartSurface::no_chart)
        continue;
      TexturePicture& picture = *pictures_[surfaces[i].chart];
      picture.image = images[atlas.places[i].page];
      picture.image_place = atlas.places[i].corner.cast<int>();
      picture.halvings = atlas.halvings[surfaces[i].chart];
    }
  }

  /** \param[in] images file name of each page */
  void
  set(const KindAtlas& atlas, const std::vector<std::string>& images)
  {
    for (TexturePicture* const picture : pictures_) {
      picture->kinds_image.clear();
      picture->kinds_place.reset();
    }
    for (std::size_t k = 0; k < atlas.charts.size(); ++k) {
      TexturePicture& picture = *pictures_[atlas.charts[k]];
      picture.kinds_image = images[atlas.page_of[k]];
      picture.kinds_place = atlas.places[k];
    }
  }

  void
  keep()
  {
    before_.clear();
  }

private:
  using Place = std::optional<Eigen::Vector2i>;

  static std::tuple<std::string&, Place&, std::int32_t&, std::string&, Place&>
  placesOf(TexturePicture& picture)
  {
    return {picture.image,
            picture.image_place,
            picture.halvings,
            picture.kinds_image,
            picture.kinds_place};
  }

  std::vector<TexturePicture*> pictures_;
  std::vector<std::tuple<std::string, Place, std::int32_t, std::string, Place>> before_;
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
  , surfaces_(acmap::surfacesOf(map))
  , proposed_(acmap::proposedSurfacesOf(map))
  , atlas_(acmap::atlasOf(map, surfaces_, upDirection(map), outputs.color_tolerance))
  {}

  std::vector<std::string>
  writeAll(PicturePlaces& places)
  {
    const std::vector<std::string> images = pageNames(
        "texture", atlas_.pages.size(), outputs_.jpeg_images ? ".jpg" : ".png");
    const KindAtlas kinds = acmap::kindAtlasOf(acmap::picturesOf(map_));
    const std::vector<std::string> kind_images =
        pageNames("kinds", kinds.pages.size(), ".png");
    places.set(surfaces_, atlas_, images);
    places.set(kinds, kind_images);
    saveMapFile(place(map_name), map_);
    writePages(images, kinds, kind_images);
    if (outputs_.obj) {
      acmap::writeObj(place("map.obj"), map_, surfaces_, proposed_, atlas_);
      acmap::writeMtl(
          place(acmap::material_file_name), map_, images, !proposed_.empty());
    }
    if (outputs_.glb)
      acmap::writeGlb(
          place("map.glb"), map_, surfaces_, proposed_, atlas_, outputs_.jpeg_quality);
    if (outputs_.vertex_ply)
      acmap::writeVertexPly(place("map.ply"), map_, surfaces_);
    return names_;
  }

private:
  std::string
  place(const std::string& name)
  {
    acmap::pollRun();
    names_.push_back(name);
    return folder_.path(name);
  }

  /** Encodes the pages side by side, which takes most of the time. */
  void
  writePages(const std::vector<std::string>& images,
             const KindAtlas& kinds,
             const std::vector<std::string>& kind_images)
  {
    std::vector<std::vector<std::uint8_t>> files(images.size() + kind_images.size());
    oneapi::tbb::parallel_for(std::size_t{0}, files.size(), [&](std::size_t i) {
      if (i >= images.size()) {
        const KindAtlas::Page& page = kinds.pages[i - images.size()];
        files[i] = encodePng(page.width, page.height, page.values);
      }
      else
        files[i] = outputs_.jpeg_images
                       ? encodeJpeg(atlas_.pages[i], outputs_.jpeg_quality)
                       : encodePng(atlas_.pages[i]);
    });
    for (std::size_t i = 0; i < images.size(); ++i)
      writeBytes(images[i], files[i]);
    for (std::size_t i = 0; i < kind_images.size(); ++i)
      writeBytes(kind_images[i], files[images.size() + i]);
  }

  void
  writeBytes(const std::string& name, const std::vector<std::uint8_t>& bytes)
  {
    acmap::OutputFile file(place(name));
    file.write(bytes.data(), bytes.size());
    file.commit();
  }

  const OutputFolder& folder_;
  const CompactMap& map_;
  const CompactMapOutputs& outputs_;
  std::vector<acmap::ChartSurface> surfaces_, proposed_;
  acmap::TextureAtlas atlas_;
  std::vector<std::string> names_;
};

} // namespace

std::vector<std::string>
saveCompactMap(const std::string& folder,
               CompactMap& map,
               const CompactMapOutputs& outputs)
{
  if (outputs.jpeg_quality < 1 || outputs.jpeg_quality > 100)
    throw acmap::BadArgument("jpeg_quality = " + std::to_string(outputs.jpeg_quality) +
                             " is refused: it must be within [1, 100]");
  constexpr double maximum_tolerance = 255;
  if (!(outputs.color_tolerance >= 0 && outputs.color_tolerance <= maximum_tolerance))
    throw acmap::BadArgument(
        "color_tolerance = " + std::to_string(outputs.color_tolerance) +
        " is refused: it must be within [0, 255]");
  acmap::requireConsistent(map);
  requireWholeCharts(map);
  PicturePlaces places(map);
  OutputFolder target(folder);
  const std::vector<std::string> written =
      MapFolderWriter(target, map, outputs).writeAll(places);
  target.commit();
  places.keep();
  return written;
}

std::vector<std::string>
saveCompactMap(const std::string& folder,
               const CompactMap& map,
               const CompactMapOutputs& outputs)
{
  CompactMap copy = map;
  return saveCompactMap(folder, copy, outputs);
}

} // namespace pcl
