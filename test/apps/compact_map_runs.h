#pragma once

#include "run_tool.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <functional>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Runs pcl_compact_mapping, without an X server unless the environment is
 * given. */
ToolRun
runMapping(const std::vector<std::string>& arguments, RunSettings settings = {});

/** \brief Runs pcl_plane_texturing. */
ToolRun
runTexturing(const std::vector<std::string>& arguments,
             const RunSettings& settings = {});

/** \brief A folder with the first four observations of the simulated corridor, made
 * once per program, and the map that pcl_compact_mapping computed from it. */
struct Corridor {
  std::string session;
  std::string merged; ///< .pcd of all points, x y z rgb view
  std::string map;    ///< folder
  std::string planes; ///< its map.json
  ToolRun run;        ///< the run that made the map
};

const Corridor&
corridor();

/** \brief A copy of the session, which a test may modify. \return its path */
std::string
copyOfSession(const std::string& folder);

/** \brief Name of an observation's file in a session. */
std::string
observation(const std::string& session, int number);

/** \brief Rewrites an observation with a changed VIEWPOINT. */
void
changeViewpoint(const std::string& path,
                const std::function<void(PointCloud<PointXYZRGB>&)>& change);

} // namespace pcl::acmap::test
