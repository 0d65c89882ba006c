#pragma once

#include "export/chart_surface.h"

#include <string>

namespace pcl::acmap {

constexpr const char* material_file_name = "map.mtl";

/** \brief From the frame of a map to one with y up, as readers of OBJ and glTF have it: a
 * turn by quarters. */
Eigen::Matrix3d
turnToYUp(const CompactMap& map);

/** \brief Writes Wavefront OBJ, y up: a group and a material a surface; texture
 * coordinates begin bottom left. Charts name their images.
 * \throws OutputFileException */
void
writeObj(const std::string& path,
         const CompactMap& map,
         const std::vector<ChartSurface>& surfaces);

/** \brief Writes the materials of \ref writeObj. */
void
writeMtl(const std::string& path,
         const CompactMap& map,
         const std::vector<ChartSurface>& surfaces);

/** \brief Writes binary glTF 2.0, y up, with the images inside. Needs no extension: of a
 * colour a share shines by itself, the rest is lit.
 * \param[in] quality of the JPEGs, 1 to 100
 * \throws OutputFileException also when it would be longer than 4 GiB or there is no
 * memory for it */
void
writeGlb(const std::string& path,
         const CompactMap& map,
         const std::vector<ChartSurface>& surfaces,
         int quality);

/** \brief Writes a PLY with a coloured vertex for each texel that is known, at its
 * middle, and triangles between neighbours.
 * \throws BadArgumentException when there are more than 2^28 - 1 of them */
void
writeVertexPly(const std::string& path,
               const CompactMap& map,
               const std::vector<ChartSurface>& surfaces);

/** \brief The colours of a chart, grey where nothing is known. */
RgbImage
withGrey(const TextureChart& chart);

} // namespace pcl::acmap
