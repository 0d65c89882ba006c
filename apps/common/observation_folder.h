#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/output_folder.h>

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace pcl::acmap {

constexpr const char* trajectory_name = "trajectory.txt";

/** \brief Name of a file that belongs to an observation: begin_0000.ending and on. */
std::string
numberedName(const std::string& begin, std::size_t index, const std::string& ending);

/** \brief Name of an observation's file: observation_0000.pcd and on. */
std::string
observationName(std::size_t index);

/** \brief Whether a file of that name would be taken for a part of a sequence. */
bool
isSequenceName(const std::string& name);

/** \brief Refuses a folder that holds parts of a sequence, which new ones would mix with.
 * \param[in] more names that it must not hold either
 * \throws OutputFileException naming what it holds */
void
requireNoSequence(const OutputFolder& folder,
                  const std::vector<std::string>& more = {});

/** \brief Writes an observation with its pose as VIEWPOINT.
 * \param[in] cloud organized, camera frame, metres
 * \throws OutputFileException as pcl::savePointCloud */
void
saveObservation(const std::string& path,
                const PCLPointCloud2& cloud,
                const Eigen::Isometry3d& T_map_camera);

} // namespace pcl::acmap
