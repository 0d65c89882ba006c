#pragma once

#include "run_tool.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Runs pcl_dewall_surface. */
ToolRun
runSurface(const std::vector<std::string>& arguments, const RunSettings& settings = {});

/** \brief Runs pcl_compact_viewer. */
ToolRun
runViewer(const std::vector<std::string>& arguments, const RunSettings& settings = {});

/** \brief Runs pcl_plane_extraction. */
ToolRun
runPlanes(const std::vector<std::string>& arguments, const RunSettings& settings = {});

/** \brief A cloud as text in PCD format. */
std::string
pcdText(const PointCloud<PointXYZ>& cloud);

/** \brief A noisy plane that can easily be triangulated. */
std::string
planePcd(int columns = 20);

} // namespace pcl::acmap::test
