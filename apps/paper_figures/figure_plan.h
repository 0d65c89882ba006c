#pragma once

#include <pcl/core/yaml_node.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Where the eye stands and what is in the middle of the picture, metres. */
struct FigureEye {
  Eigen::Vector3f from = Eigen::Vector3f::Zero();
  Eigen::Vector3f look = Eigen::Vector3f::UnitZ();
};

/** \brief An observation and the eye that looks at it, in its camera's frame. */
struct ObservationFigure {
  std::size_t observation = 0;
  FigureEye eye;
};

/** \brief What a file of figures says. */
struct FigurePlan {
  std::string scene;            ///< for which it was made
  std::size_t observations = 0; ///< likewise
  int width = 0;                ///< pixels, of a figure

  ObservationFigure fusion;                    ///< Fig. 2
  std::array<std::size_t, 3> patterns;         ///< of Fig. 2
  std::vector<ObservationFigure> acquisitions; ///< Fig. 3
  double cut = 0; ///< of Fig. 4, metres above and below the first camera
  std::vector<FigureEye> perspectives; ///< of Fig. 4, map frame
  ObservationFigure walls;             ///< Fig. 5
  std::size_t wall_steps = 0;
  ObservationFigure mesh;           ///< Fig. 7
  FigureEye inside;                 ///< Fig. 8, map frame
  std::array<FigureEye, 2> outside; ///< Fig. 9 and 10, map frame

  /** \brief Refuses observations and patterns that a session has not.
   * \throws InputFileException naming line, column and what there is */
  void
  requireWithin(std::size_t session_observations, std::size_t session_patterns) const;

  /** \brief Where the numbers of observations and patterns stand, for messages. */
  std::vector<YamlNode> observation_nodes, pattern_nodes;
};

/** \brief Reads a file of figures; its form stands in doc/tools/pcl_paper_figures.md.
 * \param[in] path empty: share/paper_figures.yaml, which is part of the tool
 * \throws InputFileException naming file, line, column and fault */
FigurePlan
loadFigurePlan(const std::string& path);

} // namespace pcl::acmap
