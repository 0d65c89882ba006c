#pragma once

#include <pcl/core/impl/yaml_node.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Position of the eye and the point that it looks at, metres. */
struct FigureEye {
  Eigen::Vector3f from = Eigen::Vector3f::Zero();
  Eigen::Vector3f look = Eigen::Vector3f::UnitZ();
};

/** \brief An observation and the eye for its picture, in the camera's frame. */
struct ObservationFigure {
  std::size_t observation = 0;
  FigureEye eye;
};

/** \brief Content of a file of figures. */
struct FigurePlan {
  std::string scene;            ///< scene for which it was made
  std::size_t observations = 0; ///< likewise
  int width = 0;                ///< pixels, of a figure

  ObservationFigure fusion;                    ///< Fig. 2
  std::array<std::size_t, 3> patterns;         ///< Fig. 2
  std::vector<ObservationFigure> acquisitions; ///< Fig. 3
  double cut = 0; ///< Fig. 4, range above and below the first camera, metres
  std::vector<FigureEye> perspectives; ///< Fig. 4, map frame
  ObservationFigure walls;             ///< Fig. 5
  std::size_t wall_steps = 0;
  ObservationFigure mesh;           ///< Fig. 7
  FigureEye inside;                 ///< Fig. 8, map frame
  std::array<FigureEye, 2> outside; ///< Fig. 9 and 10, map frame

  /** \brief Refuses observations and patterns that the session does not have.
   * \throws InputFileException naming line, column and what there is */
  void
  requireWithin(std::size_t session_observations, std::size_t session_patterns) const;

  /** \brief Nodes with the numbers of observations and patterns, for messages. */
  std::vector<YamlNode> observation_nodes, pattern_nodes;
};

/** \brief Reads a file of figures; its format is described in
 * doc/benchmarks/acmap_paper_figures.md.
 * \param[in] path empty: paper_figures.yaml, which is part of the tool
 * \throws InputFileException naming file, line, column and fault */
FigurePlan
loadFigurePlan(const std::string& path);

/** \brief The text of paper_figures.yaml. */
const char*
standardFiguresText();

} // namespace pcl::acmap
