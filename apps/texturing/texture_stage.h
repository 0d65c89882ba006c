#pragma once

#include "tool.h"

#include <pcl/core/compact_map.h>
#include <pcl/pipeline/map_painting.h>
#include <pcl/point_types.h>
#include <pcl/texture/compact_map_folder.h>
#include <pcl/texture/plane_texturing.h>

#include <string>

namespace pcl::acmap {

/** \brief Options for texturing planes. */
struct TextureOptions {
  PlaneTexturing<PointXYZRGB> stage; ///< without planes
  CompactMapOutputs outputs;
  bool skip_broken = false;
};

/** \brief Adds the options to the command line. */
void
addTextureOptions(Tool& tool, TextureOptions& options);

/** \brief Reports a texturing: warnings, summary and JSON report. */
void
tellTexture(const TexturingReport& report, StageLog& log);

/** \brief The painting with these options. */
MapPainting
paintingOf(const TextureOptions& options, const RunControls& controls);

/** \brief Reports the size of the raw points (16 bytes per finite point) and of the
 * map: map.glb, map.json, and geometry alone, 16 bytes per plane and 12 per corner.
 * \param[in] points number of finite points of the input
 * \param[in] folder of the map, already written */
void
tellCompactness(std::size_t points,
                const CompactMap& map,
                const std::string& folder,
                StageLog& log);

} // namespace pcl::acmap
