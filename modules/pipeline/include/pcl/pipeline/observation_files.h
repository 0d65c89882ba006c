#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/export.h>
#include <pcl/core/trajectory.h>

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace pcl {

struct PointCloudFile;

namespace acmap {

/** \brief Name of a file that belongs to an observation: begin_0000.ending and so
 * on. */
ACMAP_EXPORT std::string
numberedName(const std::string& begin, std::size_t index, const std::string& ending);

/** \brief Name of the file of an observation: observation_0000.pcd and so on. */
ACMAP_EXPORT std::string
observationName(std::size_t index);

/** \brief Would a file of that name be read as a part of a sequence? */
ACMAP_EXPORT bool
isSequenceName(const std::string& name);

/** \brief Does a name have the form observation_0012.pcd? */
ACMAP_EXPORT bool
isNumbered(const std::string& name);

/** \brief Lists the PCD files of a folder that form its sequence, in the order of
 * \ref inSequence; if there are none, its PLY, LAS, E57 or XYZ files, or scans of KITTI
 * (.bin), which may stand in its folder velodyne.
 * \throws InputFileException if it is no folder, or holds no cloud */
ACMAP_EXPORT std::vector<std::string>
observationNames(const std::string& folder);

/** \brief The same, as paths. */
ACMAP_EXPORT std::vector<std::string>
observationPaths(const std::string& folder);

/** \brief Orders the names of PCD files as a sequence: observation_0000.pcd and so on
 * by their numbers, without the other files; if no file is numbered, all files by
 * name, with numbers in it by value. */
ACMAP_EXPORT std::vector<std::string>
inSequence(std::vector<std::string> names);

/** \brief Finds the row of a trajectory for each file of a sequence.
 *
 * If there are as many rows as files, they correspond in their order, whatever numbers
 * the names skip. Otherwise the number in the name of a file is its row; files without
 * numbers take the rows in their order.
 * \param[in] trajectory path, for the message
 * \param[in] names of the files
 * \param[in] rows number of rows
 * \throws InputFileException if a file has no row */
ACMAP_EXPORT std::vector<std::size_t>
trajectoryRows(const std::string& trajectory,
               const std::vector<std::string>& names,
               std::size_t rows);

/** \brief Name of the file with the times of observations whose poses are unknown. */
constexpr const char* times_name = "times.txt";

/** \brief Writes a line for each observation of a folder, with its time in seconds.
 * \throws OutputFileException when the file could not be written completely */
ACMAP_EXPORT void
saveTimes(const std::string& path, const std::vector<double>& times);

/** \brief Reads them.
 * \throws InputFileException naming file, line and word */
ACMAP_EXPORT std::vector<double>
loadTimes(const std::string& path);

/** \brief Sensor positions of the observations that the int32 field `view` of a file's
 * cloud refers to: those of the file, or of the `trajectory.txt` next to it.
 * \param[in] path of the file that the cloud was read from
 * \param[in] scale metres in a unit of the trajectory
 * \param[out] remarks gets one when the positions are not known
 * \return metres; none for a cloud without that field
 * \throws InputFileException when the trajectory cannot be read */
ACMAP_EXPORT std::vector<Eigen::Vector3f>
viewpointsOfFile(const PointCloudFile& file,
                 const std::string& path,
                 double scale,
                 std::vector<std::string>& remarks);

/** \brief Writes an observation with its pose as VIEWPOINT.
 * \param[in] path of the file
 * \param[in] cloud organized, camera frame, metres
 * \param[in] T_map_camera pose
 * \throws OutputFileException as pcl::savePointCloud */
ACMAP_EXPORT void
saveObservation(const std::string& path,
                const PCLPointCloud2& cloud,
                const Eigen::Isometry3d& T_map_camera);

} // namespace acmap

} // namespace pcl
