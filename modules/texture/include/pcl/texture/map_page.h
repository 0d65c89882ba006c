#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/trajectory.h>

#include <string>

namespace pcl {

/** \brief Writes a map as one HTML page that needs nothing else: no server, no network. A
 * browser with WebGL shows the textured map, which can be turned, its layers, and the card
 * of a plane that is clicked. The page is drawn by three.js, which is a part of it.
 * \param[in] map folder with map.json and map.glb, from \ref saveCompactMap
 * \param[in] before poses before the rectification, which are shown beside those of the map,
 * metres; empty: none
 * \throws InputFileException when one of both files cannot be read
 * \throws OutputFileException when the page could not be written \ingroup texture */
ACMAP_EXPORT void
saveMapPage(const std::string& path,
            const std::string& map,
            const Trajectory& before = {});

} // namespace pcl
