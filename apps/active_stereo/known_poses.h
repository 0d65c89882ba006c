#pragma once

#include "shot_source.h"

#include <pcl/core/output_folder.h>
#include <pcl/core/trajectory.h>

#include <cstddef>
#include <string>

namespace pcl::acmap {

/** \brief Known poses of a session's observations, by their numbers; or none. */
class KnownPoses {
public:
  /** \param[in] path of a trajectory, empty for no poses
   * \throws InputFileException when it cannot be read, or has too few poses for the
   * session */
  KnownPoses(const std::string& path, const ShotSource& source);

  /** \return T_map_camera, the identity without poses
   * \throws InputFileException when there is none for the observation */
  Eigen::Isometry3d
  of(std::size_t observation) const;

  /** \brief Writes them as the trajectory of the sequence, if there are any. */
  void
  save(const OutputFolder& folder) const;

private:
  std::string path_;
  Trajectory trajectory_;
};

} // namespace pcl::acmap
