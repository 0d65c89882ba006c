#pragma once

#include "atlas/texture_atlas.h"
#include "export/chart_surface.h"

#include <string>
#include <vector>

namespace pcl::acmap {

constexpr const char* material_file_name = "map.mtl";

/** \brief The layer of what was not seen, and its material: half transparent blue. */
namespace proposed_layer {
constexpr const char* name = "proposed";
constexpr double red = 0.35, green = 0.55, blue = 0.9, opacity = 0.35;
} // namespace proposed_layer

/** \brief Rotation by multiples of 90 degrees from the frame of a map to one with y up,
 * as readers of OBJ and glTF expect it. */
Eigen::Matrix3d
turnToYUp(const CompactMap& map);

/** \brief Writes Wavefront OBJ, y up, with one group and one material per page of the
 * atlas. The origin of the texture coordinates is bottom left. What is proposed is the
 * last group, if there is any.
 * \param[in] proposed surfaces of \ref proposedSurfacesOf
 * \throws OutputFileException */
void
writeObj(const std::string& path,
         const CompactMap& map,
         const std::vector<ChartSurface>& surfaces,
         const std::vector<ChartSurface>& proposed,
         const TextureAtlas& atlas);

/** \brief Writes the material file for \ref writeObj.
 * \param[in] images file name of each page
 * \param[in] has_proposed writes the material of what is proposed, too */
void
writeMtl(const std::string& path,
         const CompactMap& map,
         const std::vector<std::string>& images,
         bool has_proposed);

/** \brief Writes binary glTF 2.0, y up, with the pages as embedded images and one
 * primitive per page. Needs no extension: one share of each colour is emitted, the rest
 * is reflected. What is proposed is a node of its own, if there is any.
 * \param[in] proposed surfaces of \ref proposedSurfacesOf
 * \param[in] quality of the JPEG images, 1 to 100
 * \throws OutputFileException also when the file would be longer than 4 GiB or memory
 * runs out */
void
writeGlb(const std::string& path,
         const CompactMap& map,
         const std::vector<ChartSurface>& surfaces,
         const std::vector<ChartSurface>& proposed,
         const TextureAtlas& atlas,
         int quality);

/** \brief Writes a PLY with a coloured vertex at the centre of each known texel, and
 * triangles between neighbours.
 * \throws BadArgumentException when there are more than 2^28 - 1 of them */
void
writeVertexPly(const std::string& path,
               const CompactMap& map,
               const std::vector<ChartSurface>& surfaces);

} // namespace pcl::acmap
