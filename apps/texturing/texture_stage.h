#pragma once

#include "tool.h"

#include <pcl/core/compact_map.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/texture/compact_map_folder.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Options for texturing planes. */
struct TextureOptions {
  double texel_size = 0.02;        ///< metres
  double maximum_distance = 0.3;   ///< metres
  int maximum_texture_size = 4096; ///< texels
  int fill_distance = 5;           ///< texels
  CompactMapOutputs outputs;
  bool keep_exposure = false;
  bool skip_broken = false;
};

/** \brief Adds the options to the command line. */
void
addTextureOptions(Tool& tool, TextureOptions& options);

/** \brief Textures planes with the observations of a folder, as a step of the tool.
 * \throws InputFileException when an observation cannot be read and none may be
 * skipped */
CompactMap
paintPlanes(Tool& tool,
            const std::vector<PlanePatch>& planes,
            const ObservationSequence& sequence,
            const TextureOptions& options);

/** \brief Textures planes with the colours of one cloud in their frame. */
CompactMap
paintPlanes(Tool& tool,
            const std::vector<PlanePatch>& planes,
            const std::shared_ptr<const PointCloudFile>& cloud,
            const TextureOptions& options);

/** \brief Reports the size of the raw points (16 bytes per finite point) and of the
 * map: map.glb, map.json, and geometry alone, 16 bytes per plane and 12 per corner.
 * \param[in] points number of finite points of the input
 * \param[in] folder of the map, already written */
void
tellCompactness(Tool& tool,
                std::size_t points,
                const CompactMap& map,
                const std::string& folder);

} // namespace pcl::acmap
