#pragma once

#include "plan/wall_bodies.h"

#include <pcl/texture/floor_plan.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief An opening through its whole wall. Metres. */
struct DrawnOpening {
  PlanOpening face;         ///< the face from which it is drawn
  double depth = 0;         ///< from this face back to the other one
  bool is_measured = false; ///< the other face was seen

  /** \brief On the line of the wall, with the hinge of its leaf first; equal to the sides of
   * the opening. */
  Eigen::Vector2d hinge = Eigen::Vector2d::Zero(), lock = Eigen::Vector2d::Zero();
  bool opens_to_front = true; ///< the leaf stands in front of the face when it is open

  double
  width() const
  {
    return (face.to - face.from).norm();
  }

  Eigen::Vector2d
  onBack(const Eigen::Vector2d& place) const;
};

/** \brief Makes one opening of both faces of a wall, and tells where its leaf may turn: about
 * the side that is nearest to a corner; to the side on which a leaf was seen in the wall, or
 * into the smaller room.
 * \param[in] bodies of the plan's walls
 * \param[in] strip depth of an opening of which nothing else is known, metres */
std::vector<DrawnOpening>
drawnOpeningsOf(const FloorPlan& plan,
                const std::vector<WallBody>& bodies,
                double strip);

} // namespace pcl::acmap
