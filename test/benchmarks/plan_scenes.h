#pragma once

#include <pcl/simulation/simulated_scene.h>

#include <Eigen/Core>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief A piece of a surface where the section cuts it, metres; x and z of the scene. */
struct TrueFace {
  Eigen::Vector2d from, to; ///< seen from the left
  int wall = -1;            ///< number of its wall; -1: no wall, but it hides walls
};

/** \brief An opening of a wall, metres. */
struct TrueOpening {
  Eigen::Vector2d from, to; ///< in the middle of its wall; x and z of the scene
  bool is_window = false;
  double bottom = 0, top = 0; ///< above the floor
};

/** \brief A storey of a building, the cameras in it, and what its plan should show. */
struct PlanScene {
  std::string name;
  SimulatedScene scene;
  double floor = 0; ///< y of the scene: y points down
  std::vector<TrueFace> faces;
  std::vector<TrueOpening> openings;

  /** \brief Does a camera see a place of the section? \param[in] normal of the surface that is
   * there, towards its seen side */
  bool
  isSeen(const Eigen::Vector2d& place, const Eigen::Vector2d& normal) const;
};

/** \brief Height of the section above the floor, metres. */
inline constexpr double section_height = 1.5;

/** \brief A scene of share/scenes: its walls are the planes that are 2.5 m high. */
PlanScene
standardPlanScene(const std::string& name);

/** \brief A storey of a building model of the test data, without doors and windows in its
 * openings. Cameras look in all directions from one to three places of each space of the storey.
 * \param[in] model such as "duplex"
 * \param[in] floor height in the model, metres
 * \return nothing, with a message on stderr, without the model, node or web-ifc */
std::optional<PlanScene>
modelPlanScene(const std::string& model, double floor);

} // namespace pcl::acmap::bench
