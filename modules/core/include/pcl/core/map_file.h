#pragma once

#include <pcl/core/compact_map.h>

#include <string>

namespace pcl {

/** \brief Writes planes, the frames of their charts, the poses and the version as JSON:
 * PLANES.json where there are planes alone, map.json of a compact map. Numbers have as many
 * digits as it takes to read the same ones back; what is not known is null. Colours stay
 * out, charts name their images. The file is written beside its target and renamed into
 * place.
 * \throws BadArgumentException for what \ref loadMapFile would refuse, naming plane or
 * chart and fault: normals whose length is not 1, numbers that are not finite, loops of
 * fewer than 3 points, charts, observations and poses that make no sense
 * \throws OutputFileException when it could not be written whole. \ingroup core */
ACMAP_EXPORT void
saveMapFile(const std::string& path, const CompactMap& map);

/** \brief Reads what \ref saveMapFile wrote; charts have no colours yet.
 * \throws InputFileException naming file and fault: missing, no JSON, a version that is not
 * known, a key that is missing or of another kind, numbers that are not finite, a chart of
 * a plane or polygon that is not there, nonsense sizes, charts of more than 2^28 texels
 * together. \ingroup core */
ACMAP_EXPORT CompactMap
loadMapFile(const std::string& path);

} // namespace pcl
