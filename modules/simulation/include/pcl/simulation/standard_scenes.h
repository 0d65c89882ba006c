#pragma once

#include <pcl/core/export.h>
#include <pcl/simulation/simulated_scene.h>

#include <string>
#include <vector>

namespace pcl {

/** \brief Names of the scenes on which acmap is evaluated: `corridor`,
 * `corridor_drive`, `corridor_survey`, `l_corridor`, `l_corridor_drive`, `loop`,
 * `office`, `room`. \ingroup simulation */
ACMAP_EXPORT const std::vector<std::string>&
standardSceneNames();

/** \brief Returns a standard scene of share/scenes. Its text is part of the library; no
 * file is read.
 * \throws BadArgumentException for any other name, listing the valid names
 * \ingroup simulation */
ACMAP_EXPORT SimulatedScene
standardScene(const std::string& name);

/** \brief Opens a standard scene by its name, or else a scene file.
 * \throws InputFileException if there is no such file, listing the names, or it is malformed
 * \ingroup simulation */
ACMAP_EXPORT SimulatedScene
openSimulatedScene(const std::string& name_or_path);

namespace acmap {

/** \brief The names as "a, b, c", for messages. */
ACMAP_EXPORT std::string
listOfScenes();

} // namespace acmap

} // namespace pcl
