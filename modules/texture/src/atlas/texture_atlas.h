#pragma once

#include "export/chart_surface.h"

#include <pcl/core/compact_map.h>

#include <array>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Where the colours of a surface are in the pages of an atlas. */
struct AtlasPlace {
  std::size_t page = 0;
  Eigen::Vector2d corner = Eigen::Vector2d::Zero(); ///< of its chart, in texels
  double scale = 0; ///< texels of the page per texel of the chart
};

/** \brief What readers of a map can be expected to display. */
struct AtlasLimits {
  std::int32_t longest_page = 4096; ///< power of two; of every graphics card
  std::size_t maximum_pages = 4;    ///< of a quarter of a gigabyte of memory
};

/** \brief All charts of a map in few images. */
struct TextureAtlas {
  std::vector<RgbImage> pages;        ///< sides are powers of two
  std::vector<AtlasPlace> places;     ///< of each surface
  std::vector<std::int32_t> halvings; ///< of each picture of \ref picturesOf

  /** \brief Texture coordinates of a point of a surface, from the top left.
   * \param[in] surface index in \a places
   * \param[in] place as in ChartSurface */
  Eigen::Vector2d
  coordinates(std::size_t surface, const Eigen::Vector2d& place) const
  {
    const AtlasPlace& at = places[surface];
    const RgbImage& page = pages[at.page];
    return (at.corner + at.scale * place)
        .cwiseQuotient(Eigen::Vector2d(page.width, page.height));
  }
};

/** \brief Packs the pictures of all charts (\ref pictureOf) into pages. Charts begin at
 * multiples of 16 texels and continue for at least four texels beyond their borders, so
 * that interpolation, two levels of mipmaps and the blocks of JPEG do not mix them.
 * Surfaces without any known colour are grey; cylinders without one, and all surfaces if
 * none has a colour, are shaded by their normals. If there were too many pages, all charts are
 * halved until there are not.
 * \param[in] surfaces of \ref surfacesOf
 * \param[in] up direction of the map
 * \param[in] tolerance of \ref PictureSettings */
TextureAtlas
atlasOf(const CompactMap& map,
        const std::vector<ChartSurface>& surfaces,
        const Eigen::Vector3d& up,
        double tolerance,
        const AtlasLimits& limits = {});

/** \brief The kinds of those pictures that were not seen completely, in few images. */
struct KindAtlas {
  struct Page {
    std::int32_t width, height;
    std::vector<std::uint8_t> values; ///< TexelKind, rows from the top
  };

  std::vector<Page> pages;
  std::vector<std::size_t> charts;  ///< numbers of the pictures that are in the pages
  std::vector<std::size_t> page_of; ///< of each of these
  std::vector<Eigen::Vector2i> places; ///< column and row of each of these
};

KindAtlas
kindAtlasOf(const std::vector<const TexturePicture*>& pictures);

} // namespace pcl::acmap
