#pragma once

#include <string>

namespace pcl::acmap {

/** \brief Kind of a file or folder, judged by its name and a short look at its
 * content. */
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

/** \brief Checks extensions, names and the first bytes; never throws. */
InputKind
inputKindOf(const std::string& path);

/** \brief Advice for an input that this tool cannot use, but another tool or option
 * can.
 * \param[in] tool name of the program
 * \param[in] positional name of the argument that received the input
 * \return one sentence with a command; empty if the kind of input is unknown, or fits
 * the argument */
std::string
toolForInput(const std::string& tool,
             const std::string& positional,
             const std::string& path);

} // namespace pcl::acmap
