#pragma once

#include <pcl/core/compact_map.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {

/** \brief Files that are written in addition to map.json. \ingroup texture */
struct CompactMapOutputs {
  bool obj = true;          ///< map.obj with map.mtl; y up
  bool glb = true;          ///< map.glb with the pages as embedded JPEG images; y up
  bool vertex_ply = false;  ///< map.ply with one coloured vertex per texel
  int jpeg_quality = 85;    ///< 1 to 100
  bool jpeg_images = false; ///< write the pages as JPEG instead of PNG

  /** \brief Charts are stored at half of their width and height, once or several times,
   * as long as their colours, enlarged again, differ by at most this: root mean square
   * in levels of 255; in each block of 8 x 8 texels at most three times this. A chart of
   * one colour becomes one texel. From 0, which keeps all texels, to 255. */
  double color_tolerance = 1.5;
};

/** \brief Writes a compact map into a folder, which is created if it does not exist:
 * map.json, the pages of the atlas, and the files requested by \a outputs.
 *
 * All charts are packed into few pages texture_0.png ..., whose sides are powers of two
 * and at most 4096; the page of kinds_0.png has the kinds of the texels. map.obj and
 * map.glb show the same pages. Their colours are those of the map multiplied by
 * CompactMap::exposure. Unknown texels are grey there, and a map without any known
 * colour is shaded by its normals. There are at most four pages: the charts of larger maps
 * are halved until they fit, as are charts with a side of more than 4088 texels.
 *
 * The files are moved into place together, after all of them have been written
 * completely; if one of these renames fails, new files can be left beside old ones.
 * \param[in,out] map its charts get their places in the pages
 * \return names of the written files, relative to the folder
 * \throws BadArgumentException when the outputs are invalid, a chart lacks some of its
 * colours or kinds, or \ref loadCompactMap would refuse the map (see \ref saveMapFile)
 * \throws OutputFileException when a file could not be written completely; the folder
 * is then unchanged, unless such a rename failed. \ingroup texture */
ACMAP_EXPORT std::vector<std::string>
saveCompactMap(const std::string& folder,
               CompactMap& map,
               const CompactMapOutputs& outputs = {});

/** \brief The same for a map that stays as it is: its pictures are copied, and only the
 * copies get their places. \ingroup texture */
ACMAP_EXPORT std::vector<std::string>
saveCompactMap(const std::string& folder,
               const CompactMap& map,
               const CompactMapOutputs& outputs = {});

/** \brief Reads map.json and its images, also those of older maps with one image per
 * chart. The colours are divided by the exposure, so that they are those of the input;
 * texels that were stored at 255 can have been brighter. Charts that name no image have
 * no colours.
 * \throws InputFileException as \ref loadMapFile and \ref loadRgbImage, and when a
 * chart is not inside of its image or the name of an image refers to a place outside the
 * folder. \ingroup texture */
ACMAP_EXPORT CompactMap
loadCompactMap(const std::string& folder);

} // namespace pcl
