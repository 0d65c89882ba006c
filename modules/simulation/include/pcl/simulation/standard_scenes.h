#pragma once

#include <pcl/core/export.h>
#include <pcl/simulation/simulated_scene.h>

#include <string>
#include <vector>

namespace pcl {

/** \brief Names of the scenes that acmap measures itself with: `corridor`,
 * `corridor_drive`, `corridor_survey`, `l_corridor`, `l_corridor_drive`, `loop`,
 * `office`. \ingroup simulation */
ACMAP_EXPORT const std::vector<std::string>&
standardSceneNames();

/** \brief A standard scene, as its file in share/scenes says; the text is part of the
 * library, no file is read.
 * \throws BadArgumentException for another name, telling those there are
 * \ingroup simulation */
ACMAP_EXPORT SimulatedScene
standardScene(const std::string& name);

} // namespace pcl
