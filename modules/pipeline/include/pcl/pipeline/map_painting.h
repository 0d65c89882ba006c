#pragma once

#include <pcl/core/cloud_rows.h>
#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/core/progress.h>
#include <pcl/pipeline/cost_callback.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/point_types.h>
#include <pcl/texture/plane_texturing.h>

#include <string>
#include <vector>

namespace pcl {

/** \brief How the surfaces of a map are painted. \ingroup pipeline */
struct MapPainting {
  PlaneTexturing<PointXYZRGB> texturing; ///< without planes and observations
  bool skip_broken = false;              ///< leave out observations that cannot be read
  unsigned threads = 0;                  ///< 0 for all
  ProgressCallback progress;
  CostCallback cost; ///< gets the memory of the textures
};

/** \brief A painted map. \ingroup pipeline */
struct PaintedMap {
  CompactMap map;
  TexturingReport report;
  std::vector<std::string> remarks; ///< on the observations, each once
};

/** \brief Paints the planes and cylinders of a map with what observations have seen of them,
 * and names its surfaces and rooms. Section II-C of "Active Stereo Based Compact Mapping".
 * \code
 * pcl::PaintedMap painted = pcl::paintMap (pcl::loadMapFile ("planes.json"),
 *                                          pcl::ObservationSequence ("posed"));
 * pcl::saveCompactMap ("map", painted.map);
 * \endcode
 * \param[in] surfaces map whose planes, cylinders, boxes and recesses the result has
 * \param[in] sequence observations with poses in the frame of the map; each is read once
 * \throws InputFileException when an observation cannot be read and none may be skipped, none
 * can be read, or all have the same pose
 * \throws CancelledException when the progress callback requests it, and what the callback for
 * the cost throws \ingroup pipeline */
ACMAP_EXPORT PaintedMap
paintMap(const CompactMap& surfaces,
         const ObservationSequence& sequence,
         const MapPainting& painting = {});

/** \brief The same with the colours of one cloud in the frame of the map.
 * \throws as above \ingroup pipeline */
ACMAP_EXPORT PaintedMap
paintMap(const CompactMap& surfaces,
         const CloudRows& cloud,
         const MapPainting& painting = {});

} // namespace pcl
