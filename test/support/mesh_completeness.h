#pragma once

#include "mesh_checker.h"

#include <string>

namespace pcl::acmap::test {

/** \brief The rule against which completeness is judged. */
struct CompletenessRule {
  EdgeAllowed edge_allowed;

  /** \brief Sharpest fold across a shared edge, radians: 0 is flat, pi lies back over the
   * neighbour. Triangles within \ref turn_slack of it may be there or not. */
  double turn_limit = 0;
  double turn_slack = 1e-4;

  /** \brief A point closer to the centre than (1 - slack) radii occupies the sphere. A
   * sphere with a point within the slack may count as empty or not. */
  double sphere_slack = 1e-6;

  /** \brief Triangles flatter than this may be left out, see \ref areaRatio. */
  double least_area_ratio = 1e-6;
};

/** \brief Triangles that are not in the mesh, but could be added without breaking a
 * guarantee: every triple with an empty smallest circumsphere is tried. */
Triangles
missingUnderPaperRule(const Points& points,
                      const Triangles& mesh,
                      const CompletenessRule& rule);

/** \brief As above for the rule without sphere test: over each open edge its
 * Delaunay-nearest apex, and empty spheres through three points that no face uses. */
Triangles
missingUnderDenseRule(const Points& points,
                      const Triangles& mesh,
                      const CompletenessRule& rule);

/** \brief Fold across the edge a-b between the faces a-b-p and a-b-q, whatever their
 * orientation, radians: 0 when flat. */
double
turnAngle(const Eigen::Vector3d& a,
          const Eigen::Vector3d& b,
          const Eigen::Vector3d& p,
          const Eigen::Vector3d& q);

/** \brief Says what a missing triangle is, for messages. */
std::string
describe(const Points& points, const Triangle& triangle);

} // namespace pcl::acmap::test
