#include "atlas/texture_atlas.h"

#include "atlas/chart_picture.h"
#include "atlas/rectangle_packing.h"

#include <pcl/core/impl/map_pictures.h>
#include <pcl/core/progress.h>

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::acmap {

namespace {

constexpr std::int32_t margin = 4;     // texels around a picture
constexpr std::int32_t alignment = 16; // of the blocks of a JPEG

/** Shade of a surface without colours: bright if it faces a light above and aside. */
std::uint8_t
shadeOf(const Eigen::Vector3d& normal, const Eigen::Vector3d& up)
{
  constexpr double dark = 70, bright = 220;
  const Eigen::Vector3d side = up.unitOrthogonal();
  const Eigen::Vector3d light =
      (0.8 * up + 0.5 * side + 0.3 * up.cross(side)).normalized();
  const double share = 0.5 + 0.5 * normal.normalized().dot(light);
  return static_cast<std::uint8_t>(std::lround(dark + share * (bright - dark)));
}

/** The picture of a surface that has one colour. */
ChartPicture
plainPicture(const TexturePicture* chart, std::uint8_t level)
{
  ChartPicture picture;
  picture.image = {1, 1, {level, level, level}};
  while (chart && halvedSize(chart->colors, picture.halvings).maxCoeff() > 1)
    ++picture.halvings;
  return picture;
}

/** Copies a picture into a page and continues its border texels over its margin, up to
 * the next multiple of the alignment. */
void
paste(const RgbImage& picture, const Eigen::Vector2i& corner, RgbImage& page)
{
  const auto padded = [](std::int32_t side) {
    return (side + 2 * margin + alignment - 1) / alignment * alignment;
  };
  for (std::int32_t row = 0; row < padded(picture.height); ++row)
    for (std::int32_t column = 0; column < padded(picture.width); ++column)
      std::copy_n(picture.at(std::clamp(column - margin, 0, picture.width - 1),
                             std::clamp(row - margin, 0, picture.height - 1)),
                  3,
                  page.at(corner.x() + column, corner.y() + row));
}

/** \brief The different pictures of all surfaces. */
struct Pictures {
  std::vector<ChartPicture> own;  ///< of each surface
  std::vector<std::size_t> first; ///< surface with the same picture, of each surface
  Packing packing;                ///< of the pictures that are their own first
};

/** Packs the pictures; those of one equal texel share a place. */
void
pack(Pictures& pictures, std::int32_t longest_page)
{
  std::map<std::vector<std::uint8_t>, std::size_t> plain;
  std::vector<Eigen::Vector2i> sizes;
  std::vector<std::size_t> number; // of each surface in the packing
  pictures.first.clear();
  for (std::size_t i = 0; i < pictures.own.size(); ++i) {
    const RgbImage& image = pictures.own[i].image;
    std::size_t first = i;
    if (image.values.size() == 3)
      first = plain.try_emplace(image.values, i).first->second;
    pictures.first.push_back(first);
    number.push_back(first == i ? sizes.size() : number[first]);
    if (first == i)
      sizes.emplace_back(image.width + 2 * margin, image.height + 2 * margin);
  }
  Packing packing = packedRectangles(sizes, alignment, longest_page);
  pictures.packing.pages = std::move(packing.pages);
  pictures.packing.places.clear();
  for (const std::size_t i : number)
    pictures.packing.places.push_back(packing.places[i]);
}

/** Halvings without which a chart is longer than a page. */
std::int32_t
neededHalvings(const TexturePicture& chart, std::int32_t longest_page)
{
  std::int32_t halvings = 0;
  while (halvedSize(chart.colors, halvings).maxCoeff() > longest_page - 2 * margin)
    ++halvings;
  return halvings;
}

Pictures
packedPictures(const CompactMap& map,
               const std::vector<ChartSurface>& surfaces,
               const Eigen::Vector3d& up,
               double tolerance,
               const AtlasLimits& limits)
{
  Pictures pictures;
  pictures.own.resize(surfaces.size());
  const std::vector<const TexturePicture*> charts = picturesOf(map);
  const bool is_colorless =
      std::none_of(charts.begin(), charts.end(), [](const TexturePicture* chart) {
        return hasColor(*chart);
      });
  const auto draw = [&](std::size_t i, std::int32_t min_halvings) {
    const ChartSurface& surface = surfaces[i];
    const bool has_chart = surface.chart != ChartSurface::no_chart;
    const TexturePicture* const chart = has_chart ? charts[surface.chart] : nullptr;
    if (!chart || !hasColor(*chart)) {
      const bool is_shaded = is_colorless || surface.plane >= map.planes.size();
      pictures.own[i] =
          plainPicture(chart, is_shaded ? shadeOf(surface.normal, up) : unknown_grey);
      return;
    }
    PictureSettings settings;
    settings.exposure = map.exposure;
    settings.tolerance = tolerance;
    settings.min_halvings =
        std::max(neededHalvings(*chart, limits.longest_page), min_halvings);
    pictures.own[i] = pictureOf(*chart, coverOf(surface, chart->colors), settings);
  };
  for (std::int32_t min_halvings = 0;; ++min_halvings) {
    oneapi::tbb::parallel_for(std::size_t{0}, surfaces.size(), [&](std::size_t i) {
      pollRun();
      draw(i, min_halvings);
    });
    pack(pictures, limits.longest_page);
    if (pictures.packing.pages.size() <= limits.maximum_pages)
      return pictures;
  }
}

} // namespace

TextureAtlas
atlasOf(const CompactMap& map,
        const std::vector<ChartSurface>& surfaces,
        const Eigen::Vector3d& up,
        double tolerance,
        const AtlasLimits& limits)
{
  const Pictures pictures = packedPictures(map, surfaces, up, tolerance, limits);
  TextureAtlas atlas;
  atlas.halvings.resize(map.charts.size() + map.cylinder_pictures.size());
  for (const Eigen::Vector2i& size : pictures.packing.pages) {
    RgbImage& page = atlas.pages.emplace_back();
    page.width = size.x();
    page.height = size.y();
    page.values.assign(3 * static_cast<std::size_t>(size.x()) *
                           static_cast<std::size_t>(size.y()),
                       unknown_grey);
  }
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const ChartPicture& picture = pictures.own[i];
    const PackedPlace& place = pictures.packing.places[i];
    AtlasPlace& at = atlas.places.emplace_back();
    at.page = place.page;
    at.corner = place.corner.cast<double>().array() + margin;
    at.scale = std::ldexp(1.0, -picture.halvings);
    if (surfaces[i].chart == ChartSurface::no_chart)
      at.corner.array() += 0.5; // all its places are (0, 0)
    else
      atlas.halvings[surfaces[i].chart] = picture.halvings;
    if (pictures.first[i] == i)
      paste(picture.image, place.corner, atlas.pages[place.page]);
  }
  return atlas;
}

KindAtlas
kindAtlasOf(const std::vector<const TexturePicture*>& pictures)
{
  constexpr std::int32_t longest = 16384; // for acmap alone
  KindAtlas atlas;
  std::vector<Eigen::Vector2i> sizes;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const std::vector<TexelKind>& kinds = pictures[i]->kinds;
    if (std::all_of(kinds.begin(), kinds.end(), [](TexelKind kind) {
          return kind == TexelKind::Seen;
        }))
      continue;
    atlas.charts.push_back(i);
    sizes.emplace_back(pictures[i]->colors.width, pictures[i]->colors.height);
  }
  const Packing packing = packedRectangles(sizes, 1, longest);
  for (const Eigen::Vector2i& size : packing.pages)
    atlas.pages.push_back(
        {size.x(),
         size.y(),
         std::vector<std::uint8_t>(static_cast<std::size_t>(size.x()) *
                                   static_cast<std::size_t>(size.y()))});
  for (std::size_t k = 0; k < atlas.charts.size(); ++k) {
    const TexturePicture& chart = *pictures[atlas.charts[k]];
    const PackedPlace& place = packing.places[k];
    atlas.page_of.push_back(place.page);
    atlas.places.push_back(place.corner);
    KindAtlas::Page& page = atlas.pages[place.page];
    for (std::int32_t row = 0; row < chart.colors.height; ++row)
      for (std::int32_t column = 0; column < chart.colors.width; ++column)
        page.values[static_cast<std::size_t>(place.corner.y() + row) *
                        static_cast<std::size_t>(page.width) +
                    static_cast<std::size_t>(place.corner.x() + column)] =
            static_cast<std::uint8_t>(
                chart.kinds[static_cast<std::size_t>(row) *
                                static_cast<std::size_t>(chart.colors.width) +
                            static_cast<std::size_t>(column)]);
  }
  return atlas;
}

} // namespace pcl::acmap
