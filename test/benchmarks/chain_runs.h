#pragma once

#include <pcl/core/compact_map.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Settings for turning a recording into a map. */
struct ChainWay {
  std::string name;
  std::size_t every = 1;            ///< one of this number of frames is used
  bool is_given = true;             ///< use the given poses, or else estimate them
  std::vector<std::string> mapping; ///< further options of pcl_compact_mapping
};

/** \brief An observation that has a pose. */
struct ChainView {
  std::vector<Eigen::Vector3d> points; ///< one of 4 x 4 pixels, camera frame, metres
  Eigen::Isometry3d given;             ///< T_map_camera given with the recording
  Eigen::Isometry3d found;             ///< T_map_camera of the map
};

/** \brief Result of a run. */
struct ChainRun {
  std::size_t observations = 0;
  std::vector<ChainView> views; ///< all views with a pose
  CompactMap map;
  double compactness = 0;      ///< 16 bytes per point divided by the size of map.glb
  double seconds = 0;          ///< CPU time of pcl_compact_mapping
  std::size_t peak_memory = 0; ///< bytes, of pcl_compact_mapping
};

/** \brief Runs a tool and waits for its end.
 * \throws std::runtime_error when it fails, with its messages */
void
runWhole(const std::string& tool, const std::vector<std::string>& arguments);

/** \brief Imports frames of a recording in the layout of 7-Scenes and maps them.
 * \param[in] folder for the outputs, which take 10 MB per frame
 * \throws std::runtime_error when a tool fails, with its messages */
ChainRun
runChainOfTools(const ChainWay& way,
                const std::string& recording,
                const std::string& folder);

} // namespace pcl::acmap::bench
