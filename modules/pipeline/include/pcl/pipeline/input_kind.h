#pragma once

#include <pcl/core/export.h>

#include <string>

namespace pcl {

/** \brief Kind of a file or folder, judged by its name and a short look at its
 * content. \ingroup pipeline */
enum class InputKind {
  Unknown,
  RgbdFolder,   ///< colour and depth images
  RawSession,   ///< frames of a rig, also of an unfinished recording
  CompactMap,   ///< folder with a map.json, and no PCD except map.pcd
  MergedMap,    ///< folder with a trajectory.txt, and no PCD except map.pcd
  Observations, ///< folder of other PCDs
  Images,       ///< folder of pictures
  CarmenLog,
  Bag,    ///< of ROS 2
  Planes, ///< JSON
  Cloud   ///< points, or a mesh
};

/** \brief Checks extensions, names and the first bytes; never throws. \ingroup pipeline */
ACMAP_EXPORT InputKind
inputKindOf(const std::string& path);

} // namespace pcl
