#pragma once

#include <pcl/core/compact_map.h>

#include <string>

namespace pcl {

/** \brief Writes planes, the rectangles of their charts, the poses and the version as
 * JSON: PLANES.json if there are only planes, map.json for a compact map. Numbers have
 * as many digits as are needed to read back the same values; unknown values are null.
 * Colours are not written, charts contain the names of their images. The file is
 * written to a temporary file in the same folder and then renamed.
 * \throws BadArgumentException for maps that \ref loadMapFile would reject, naming
 * plane or chart and fault: normals that are not of unit length, numbers that are not
 * finite, loops of fewer than 3 points, invalid charts, observations and poses
 * \throws OutputFileException when it could not be written completely. \ingroup core */
ACMAP_EXPORT void
saveMapFile(const std::string& path, const CompactMap& map);

/** \brief Reads a file that \ref saveMapFile wrote; the charts have no colours yet.
 * \throws InputFileException naming file and fault: missing, not JSON, an unknown
 * version, a key that is missing or of another type, numbers that are not finite, a
 * chart of a plane or polygon that does not exist, invalid sizes, charts with more than
 * 2^28 texels together. \ingroup core */
ACMAP_EXPORT CompactMap
loadMapFile(const std::string& path);

} // namespace pcl
