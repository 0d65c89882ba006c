#pragma once

#include <pcl/core/compact_map.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {

/** \brief Files that are written in addition to map.json. \ingroup texture */
struct CompactMapOutputs {
  bool obj = true;          ///< map.obj with map.mtl and the images; y up
  bool glb = true;          ///< map.glb with embedded JPEG images; y up
  bool vertex_ply = false;  ///< map.ply with one coloured vertex per texel
  int jpeg_quality = 85;    ///< 1 to 100
  bool jpeg_images = false; ///< write the images of map.obj as JPEG instead of PNG
};

/** \brief Writes a compact map into a folder, which is created if it does not exist:
 * map.json, one image per chart, and the files requested by \a outputs. Unknown texels
 * are grey in image formats without transparency. The files are moved into place
 * together, after all of them have been written completely; if one of these renames
 * fails, new files can be left beside old ones.
 * \param[in,out] map its charts get the names of their images
 * \return names of the written files, relative to the folder
 * \throws BadArgumentException when the outputs are invalid, a chart lacks some of its
 * colours or kinds, or \ref loadCompactMap would refuse the map (see \ref saveMapFile)
 * \throws OutputFileException when a file could not be written completely; the folder
 * is then unchanged, unless such a rename failed. \ingroup texture */
ACMAP_EXPORT std::vector<std::string>
saveCompactMap(const std::string& folder,
               CompactMap& map,
               const CompactMapOutputs& outputs = {});

/** \brief Reads map.json and its images. Charts that name no image have no colours.
 * \throws InputFileException as \ref loadMapFile and \ref loadRgbImage, and when an
 * image does not have the size of its chart or its name refers to a place outside the
 * folder. \ingroup texture */
ACMAP_EXPORT CompactMap
loadCompactMap(const std::string& folder);

} // namespace pcl
