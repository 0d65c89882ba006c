#pragma once

#include <pcl/core/compact_map.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {

/** \brief What is written beside map.json. \ingroup texture */
struct CompactMapOutputs {
  bool obj = true;          ///< map.obj with map.mtl and the images; y up
  bool glb = true;          ///< map.glb, images inside as JPEG; y up
  bool vertex_ply = false;  ///< map.ply, a coloured vertex for each texel
  int jpeg_quality = 85;    ///< 1 to 100
  bool jpeg_images = false; ///< images beside map.obj as JPEG instead of PNG
};

/** \brief Writes a compact map into a folder, which is made where there is none: map.json,
 * an image a chart, and what the outputs ask for. Texels of which nothing is known are grey
 * in images that have no transparency. All files appear together once all are whole; a
 * rename that fails midway, after all were written, can leave new files beside old ones.
 * \param[in,out] map its charts get the names of their images
 * \return names of the files that were written, beside the folder
 * \throws BadArgumentException when outputs make no sense, a chart has not all its colours
 * and kinds, or \ref loadCompactMap would refuse the map, as \ref saveMapFile tells
 * \throws OutputFileException when a file could not be written whole; the folder is then as
 * it was, but for such a rename. \ingroup texture */
ACMAP_EXPORT std::vector<std::string>
saveCompactMap(const std::string& folder,
               CompactMap& map,
               const CompactMapOutputs& outputs = {});

/** \brief Reads map.json and its images. Charts that name no image have no colours.
 * \throws InputFileException as \ref loadMapFile and \ref loadRgbImage, and when an image
 * is not of its chart's size or its name climbs out of the folder. \ingroup texture */
ACMAP_EXPORT CompactMap
loadCompactMap(const std::string& folder);

} // namespace pcl
