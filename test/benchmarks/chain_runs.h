#pragma once

#include <pcl/core/compact_map.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief How a recording is made into a map. */
struct ChainWay {
  std::string name;
  std::size_t every = 1;            ///< of the recording's frames one is taken
  bool is_given = true;             ///< with the poses that came with it, else our own
  std::vector<std::string> mapping; ///< further options of pcl_compact_mapping
};

/** \brief An observation that has a pose. */
struct ChainView {
  std::vector<Eigen::Vector3d> points; ///< one in 4 x 4 pixels, camera frame, metres
  Eigen::Isometry3d given;             ///< T_map_camera that came with it
  Eigen::Isometry3d found;             ///< T_map_camera of the map
};

/** \brief What came of it. */
struct ChainRun {
  std::size_t observations = 0;
  std::vector<ChainView> views; ///< those that have a pose
  CompactMap map;
  double compactness = 0;      ///< 16 bytes a point over bytes of map.glb
  double seconds = 0;          ///< of pcl_compact_mapping, CPU
  std::size_t peak_memory = 0; ///< bytes, of pcl_compact_mapping
};

/** \brief Runs a tool to its end.
 * \throws std::runtime_error when it fails, with what it said */
void
runWhole(const std::string& tool, const std::vector<std::string>& arguments);

/** \brief Imports frames of a recording in 7-Scenes' layout and maps them.
 * \param[in] folder where its outputs may lie; they take 10 MB a frame
 * \throws std::runtime_error when a tool fails, with what it said */
ChainRun
runChainOfTools(const ChainWay& way,
                const std::string& recording,
                const std::string& folder);

} // namespace pcl::acmap::bench
