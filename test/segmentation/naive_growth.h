#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap::test {

/** \brief Points with unit normals. */
struct NaiveHypotheses {
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;
};

struct NaiveThresholds {
  double member_distance = 0.8; ///< W_d, metres
  double cosine = 0.923879533;  ///< of W_n
  double plane_distance = 0.25; ///< W_t, metres
  std::size_t support = 50;     ///< W_h
};

/** \brief A plane with its supporters in ascending order. */
struct NaivePlane {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double offset = 0;
  std::vector<std::int32_t> members;
};

/** \brief Are a point's normal and position consistent with a plane? */
bool
supports(const NaiveHypotheses& all,
         std::size_t point,
         const NaivePlane& plane,
         const NaiveThresholds& limits);

/** \brief Is the distance from a point to any other supporter less than W_d? */
bool
isNearSome(const NaiveHypotheses& all,
           std::size_t point,
           const NaivePlane& plane,
           const NaiveThresholds& limits);

/** \brief Least-squares plane of members, oriented like a normal. */
NaivePlane
planeThrough(const NaiveHypotheses& all,
             const std::vector<std::int32_t>& members,
             const Eigen::Vector3d& front);

/** \brief Literal implementation of the paper's clustering (II-C.2), O(n^2): each new
 * supporter updates the plane from all supporters; seeds are tried in their order. */
std::vector<NaivePlane>
growNaively(const NaiveHypotheses& all, const NaiveThresholds& limits);

} // namespace pcl::acmap::test
