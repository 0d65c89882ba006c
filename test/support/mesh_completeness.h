#pragma once

#include "mesh_checker.h"

#include <string>

namespace pcl::acmap::test {

/** \brief The rule that defines a complete mesh. */
struct CompletenessRule {
  EdgeAllowed edge_allowed;

  /** \brief Maximum fold across a shared edge, radians: 0 is flat, pi folds back onto
   * the neighbour. Triangles within \ref turn_slack of it are optional. */
  double turn_limit = 0;
  double turn_slack = 1e-4;

  /** \brief A sphere is occupied by a point whose distance from the centre is less than
   * (1 - slack) radii. A sphere with a point within the slack may count as empty or
   * not. */
  double sphere_slack = 1e-6;

  /** \brief Triangles flatter than this are optional, see \ref areaRatio. */
  double min_area_ratio = 1e-6;
};

/** \brief Triangles that could be added to the mesh without breaking a guarantee: every
 * triple with an empty smallest circumsphere is tried. */
Triangles
missingUnderPaperRule(const Points& points,
                      const Triangles& mesh,
                      const CompletenessRule& rule);

/** \brief As above for the rule without sphere test: for each open edge its
 * Delaunay-nearest apex, and empty spheres through three points that no face uses. */
Triangles
missingUnderDenseRule(const Points& points,
                      const Triangles& mesh,
                      const CompletenessRule& rule);

/** \brief Fold across the edge a-b between the faces a-b-p and a-b-q, independent of
 * their orientation, radians: 0 if flat. */
double
turnAngle(const Eigen::Vector3d& a,
          const Eigen::Vector3d& b,
          const Eigen::Vector3d& p,
          const Eigen::Vector3d& q);

/** \brief Describes a missing triangle for messages. */
std::string
describe(const Points& points, const Triangle& triangle);

} // namespace pcl::acmap::test
