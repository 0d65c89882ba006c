#pragma once

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/trajectory.h>

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief An observation with its pose. */
struct PosedObservation {
  PointCloudFile file; ///< camera frame, metres
  Eigen::Isometry3d T_map_camera = Eigen::Isometry3d::Identity();
};

/** \brief A sequence on disk: a folder of PCD files, each seen from a pose of its own, read
 * one at a time.
 *
 * The files are those of \ref observationNames. Poses are the rows of its trajectory.txt
 * that \ref trajectoryRows tells, else the VIEWPOINTs of the files. */
class PosedFolder {
public:
  /** \param[in] scale metres in a unit of clouds and trajectory
   * \throws InputFileException when it is no folder, holds no PCD, or its trajectory has
   * too few poses or cannot be read */
  PosedFolder(const std::string& path, double scale);

  /** \brief Some files of a folder, with poses that are known from elsewhere.
   * \param[in] scale metres in a unit of the clouds
   * \param[in] names of the files
   * \param[in] trajectory a row a name, metres
   * \throws InputFileException when they differ in number */
  PosedFolder(const std::string& path,
              double scale,
              std::vector<std::string> names,
              Trajectory trajectory);

  const std::string&
  folder() const
  {
    return path_;
  }

  const std::vector<std::string>&
  names() const
  {
    return names_;
  }

  /** \brief Number of observations. */
  std::size_t
  size() const
  {
    return names_.size();
  }

  /** \brief What is odd about the folder, a line each: poses without an observation. */
  std::vector<std::string>
  remarks() const;

  /** \brief Path of an observation's file. */
  std::string
  path(std::size_t i) const;

  /** \param[in,out] remarks gets a line where pose and VIEWPOINT are more than 1 mm apart
   * \throws InputFileException as pcl::loadPointCloud */
  PosedObservation
  load(std::size_t i, std::vector<std::string>& remarks) const;

  /** \brief Checks that observations seen from these poses, those of the files that could
   * be read, were told apart by somebody.
   * \throws InputFileException when there is no trajectory and the poses are all the same */
  void
  requireDifferent(const std::vector<Eigen::Isometry3d>& poses) const;

  bool
  hasTrajectory() const
  {
    return !trajectory_.poses.empty();
  }

  /** \brief Seconds; its place in the sequence where there is no trajectory. */
  double
  stamp(std::size_t i) const;

private:
  std::string path_;
  double scale_;
  std::vector<std::string> names_;
  std::vector<std::size_t> rows_; ///< of the trajectory, one an observation
  Trajectory trajectory_;
  bool is_given_ = false; ///< whether the files' own poses do not count
};

} // namespace pcl::acmap
