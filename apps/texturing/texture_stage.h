#pragma once

#include "tool.h"

#include <pcl/core/compact_map.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/texture/compact_map_folder.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief What tools that paint planes let the user choose. */
struct TextureOptions {
  double texel_size = 0.02;        ///< metres
  double maximum_distance = 0.3;   ///< metres
  int maximum_texture_size = 4096; ///< texels
  int fill_distance = 5;           ///< texels
  CompactMapOutputs outputs;
  bool keep_exposure = false;
  bool skip_broken = false;
};

/** \brief Adds them to the command line. */
void
addTextureOptions(Tool& tool, TextureOptions& options);

/** \brief Paints planes with the observations of a folder, as a step of the tool.
 * \throws InputFileException when an observation cannot be read and none may be skipped */
CompactMap
paintPlanes(Tool& tool,
            const std::vector<PlanePatch>& planes,
            const ObservationSequence& sequence,
            const TextureOptions& options);

/** \brief Paints planes with the colours of one cloud in their frame. */
CompactMap
paintPlanes(Tool& tool,
            const std::vector<PlanePatch>& planes,
            const std::shared_ptr<const PointCloudFile>& cloud,
            const TextureOptions& options);

/** \brief Raw bytes (16 a finite point) beside those of the map, for summary and report:
 * map.glb, map.json, and geometry alone, 16 bytes a plane and 12 a corner.
 * \param[in] points finite ones of the input
 * \param[in] folder of the map, written */
void
tellCompactness(Tool& tool,
                std::size_t points,
                const CompactMap& map,
                const std::string& folder);

} // namespace pcl::acmap
