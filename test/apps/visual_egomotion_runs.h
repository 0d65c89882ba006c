#pragma once

#include "json_file.h"
#include "run_tool.h"
#include "temporary_folder.h"

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/trajectory.h>

#include <nlohmann/json.hpp>

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Runs pcl_visual_egomotion. */
ToolRun
runEgomotion(const std::vector<std::string>& arguments,
             const RunSettings& settings = {});

/** \brief Observations of a simulated hall with textured walls, 160 x 120 points each,
 * and the trajectory of the camera. */
struct Hall {
  std::string session; ///< folder
  Trajectory truth;    ///< its trajectory.txt
};

/** \brief Makes a session in the folder.
 * \param[in] line of the scene's path */
Hall
walk(const TemporaryFolder& folder, const std::string& line);

/** \brief A hall with six observations, made once per program. */
const Hall&
hall();

/** \brief A copy of the folder, which a test may modify. \return its path */
std::string
copyOfHall(const std::string& folder);

/** \brief Path of an observation in a folder. */
std::string
observationIn(const std::string& folder, std::size_t i);

/** \brief Reads a cloud, changes it, and writes it to the same file. */
void
change(const std::string& pcd, const std::function<void(PCLPointCloud2&)>& edit);

/** \brief Makes all colours of a cloud black. */
void
blacken(PCLPointCloud2& cloud);

/** \brief Sets all positions of a cloud to NaN. */
void
takePlaces(PCLPointCloud2& cloud);

/** \brief Rotates all positions, as if the camera had rotated in the opposite
 * direction. */
void
turn(PCLPointCloud2& cloud, const Eigen::AngleAxisf& by);

/** \brief Removes a field. */
void
dropField(PCLPointCloud2& cloud, const std::string& name);

/** \brief Names of the entries of a folder. */
std::set<std::string>
filesIn(const std::string& folder);

} // namespace pcl::acmap::test
