#pragma once

#include "tool.h"

#include <pcl/core/compact_map.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/ranked_work.h>
#include <pcl/point_types.h>
#include <pcl/texture/compact_map_folder.h>
#include <pcl/texture/plane_texturing.h>

#include <memory>
#include <string>
#include <vector>

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

/** \brief Textures planes and cylinders with the observations of a folder, as a step of the
 * tool.
 * \param[in] surfaces map whose planes, cylinders, boxes and recesses the result has
 * \param[in] work of other processes with these observations; null: there are none
 * \throws InputFileException when an observation cannot be read and none may be
 * skipped */
CompactMap
paintPlanes(const CompactMap& surfaces,
            const ObservationSequence& sequence,
            RankedWork* work,
            const TextureOptions& options,
            const RunControls& controls,
            StageLog& log);

/** \brief The same with the colours of one cloud in the frame of the planes. */
CompactMap
paintPlanes(const CompactMap& surfaces,
            const CloudRows& cloud,
            const TextureOptions& options,
            const RunControls& controls,
            StageLog& log);

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
