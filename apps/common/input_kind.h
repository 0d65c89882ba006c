#pragma once

#include <string>

namespace pcl::acmap {

/** \brief What a file or folder is, as far as its name and a look into it tell. */
enum class InputKind {
  Unknown,
  RgbdFolder,   ///< colour and depth images
  RawSession,   ///< frames of a rig, even where the recording was not finished
  CompactMap,   ///< folder with a map.json, and no PCD but a map.pcd
  MergedMap,    ///< folder with a trajectory.txt, and no PCD but a map.pcd
  Observations, ///< folder of other PCDs
  Images,       ///< folder of pictures
  CarmenLog,
  Planes, ///< JSON
  Cloud   ///< points, or a mesh
};

/** \brief Looks at endings, names and the first bytes, and never throws. */
InputKind
inputKindOf(const std::string& path);

/** \brief Advice for an input that a tool cannot use because another tool, or an option,
 * is for it.
 * \param[in] tool name of the program
 * \param[in] positional name of the argument that the input was given for
 * \return one sentence with a command; empty where the input is unknown, or is what the
 * argument is for */
std::string
toolForInput(const std::string& tool,
             const std::string& positional,
             const std::string& path);

} // namespace pcl::acmap
