#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/trajectory.h>

#include <string>

namespace pcl {

/** \brief Can \ref saveMapPage write pages? Not if acmap was built without the modules that
 * the page consists of (ACMAP_PAGE_MODULES). \ingroup texture */
ACMAP_EXPORT bool
hasMapPage();

/** \brief Writes a map as one HTML page that needs nothing else: no server, no network. A
 * browser with WebGL shows the textured map from outside, from within and from above, with
 * names and sizes of its surfaces, and measures in it.
 * \param[in] map folder with map.json, map.glb and the images that map.json names, from \ref saveCompactMap
 * \param[in] before poses before the rectification, which are shown beside those of the map,
 * metres; empty: none
 * \throws InitFailedException unless \ref hasMapPage
 * \throws InputFileException when one of these files cannot be read, or map.json is no JSON
 * \throws OutputFileException when the page could not be written \ingroup texture */
ACMAP_EXPORT void
saveMapPage(const std::string& path,
            const std::string& map,
            const Trajectory& before = {});

} // namespace pcl
